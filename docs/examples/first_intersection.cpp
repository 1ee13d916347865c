#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>

#include <iostream>

int main() {
  const auto pair = exsect::read_patches("examples/chapter9-first.json").patches;
  const auto result = exsect::intersect(pair[0].patch, pair[1].patch);
  if (result.status != exsect::Status::complete) return 3;
  std::cout << result.graph.count(exsect::ComponentShape::closed) << " closed, "
            << result.graph.count(exsect::ComponentShape::open) << " open\n";
}
