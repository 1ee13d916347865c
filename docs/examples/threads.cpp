#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>

#include <future>
#include <iostream>
#include <vector>

int main() {
  const auto pair = exsect::read_patches("examples/chapter9-first.json").patches;
  std::vector<std::future<exsect::IntersectResult>> results;
  for (int i = 0; i < 4; ++i) {
    results.push_back(std::async(std::launch::async, [&pair] {
      exsect::IntersectOptions options;
      options.tolerance = 1e-4;
      return exsect::intersect(pair[0].patch, pair[1].patch, options);
    }));
  }
  for (auto& result : results) std::cout << result.get().graph.nodes.size() << ' ';
  std::cout << "nodes\n";
}
