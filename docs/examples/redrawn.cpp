#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/redrawn.h>

#include <iostream>

int main() {
  const auto pair = exsect::read_patches("examples/chapter9-first.json").patches;
  exsect::IntersectOptions options;
  options.tolerance = 1e-3;
  const auto rough = exsect::intersect(pair[0].patch, pair[1].patch, options);
  const auto fine = exsect::redrawn(rough, {.tolerance = 1e-9});
  std::cout << rough.graph.arcs.size() << " and " << fine.graph.arcs.size() << " arcs, the first with "
            << rough.graph.arcs[0].polyline.size() << " and " << fine.graph.arcs[0].polyline.size()
            << " vertices\n";
}
