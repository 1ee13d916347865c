// Scenes rebuilt from public reports (tests/cases/reported/README.md): answers by hand, near misses beside
// them.
#include <exsect/geometry/surface_file.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <stdexcept>

#include "support/catch.h"

namespace exsect::reported_scenes_test {
namespace {

const NamedSurface& named(const SurfaceFile& file, const std::string& name) {
  for (const NamedSurface& entry : file.surfaces)
    if (entry.name == name) return entry;
  throw std::invalid_argument("no surface " + name);
}

/// Components by shape, and crossings.
struct Counts {
  int open = 0;
  int closed = 0;
  int branched = 0;
  int crossings = 0;
  int boundary = 0;
  bool tangential = false;  // all arcs
};

void check(const std::string& scene, const std::string& first, const std::string& second,
           const Counts& right) {
  INFO(scene << " " << first << " " << second);
  const SurfaceFile file = read_surfaces(std::string(EXSECT_CASES) + "/reported/" + scene + ".json");
  const IntersectResult result = intersect(*named(file, second).equation(), *named(file, first).patch());
  CHECK(result.status == Status::complete);
  const IntersectionGraph& graph = result.graph;
  CHECK(graph.count(ComponentShape::open) == right.open);
  CHECK(graph.count(ComponentShape::closed) == right.closed);
  CHECK(graph.count(ComponentShape::branched) == right.branched);
  CHECK(graph.boundary_points() == right.boundary);
  CHECK(graph.isolated_points.empty());
  CHECK(graph.overlaps.empty());
  CHECK(std::count_if(graph.nodes.begin(), graph.nodes.end(), [](const Node& node) {
          return std::count(node.kinds.begin(), node.kinds.end(), NodeKind::crossing) > 0;
        }) == right.crossings);
  for (const Arc& arc : graph.arcs) CHECK((arc.contact == Contact::tangential) == right.tangential);
}

const std::vector<std::string> distances = {"3", "6", "12", "20"};

}  // namespace

TEST_CASE("reported scenes: two branches cross where round surfaces touch") {
  // On the patch z^2 is a t^2 + O(t^4), a > 0, and near misses add a small constant of the sign of the name:
  // two branches beside each other above and below, or to the left and to the right.
  for (const std::string scene :
       {"viviani", "equal-cylinders", "torus-outer-equator", "torus-inner-equator"}) {
    check(scene, "x", "y", {.branched = 1, .crossings = 1, .boundary = 4});
    for (const std::string& distance : distances) {
      check(scene, "x", "y+" + distance, {.open = 2, .boundary = 4});
      check(scene, "x", "y-" + distance, {.open = 2, .boundary = 4});
    }
  }
}

TEST_CASE("reported scenes: contact along a line or a circle") {
  const Counts touching = {.open = 1, .boundary = 2, .tangential = true};
  const Counts twice = {.open = 2, .boundary = 4};
  check("cylinders-along-a-line", "x", "y", touching);
  check("sphere-in-a-bore", "x", "y", touching);
  check("torus-on-a-plane", "x", "y", {.closed = 1, .tangential = true});
  for (const std::string& distance : distances) {
    check("cylinders-along-a-line", "x", "y+" + distance, {});
    check("cylinders-along-a-line", "x", "y-" + distance, twice);
    check("sphere-in-a-bore", "x", "y+" + distance, twice);
    check("sphere-in-a-bore", "x", "y-" + distance, {});
    check("torus-on-a-plane", "x", "y+" + distance, {.closed = 2});
    check("torus-on-a-plane", "x", "y-" + distance, {});
  }
}

TEST_CASE("reported scenes: Villarceau's circles") {
  check("villarceau", "x", "y", {.branched = 1, .crossings = 2});
  // The two double points open in opposite ways, as half a turn about the axis y exchanges them and the
  // sides.
  for (const std::string& distance : distances)
    for (const std::string sign : {"+", "-"}) check("villarceau", "x" + sign + distance, "y", {.closed = 1});
}

TEST_CASE("reported scenes: a rod through a torus") {
  // x = +- sqrt((10 +- sqrt(9 - z^2))^2 - y^2) over all of the arc.
  check("torus-and-rod", "x", "y", {.open = 4, .boundary = 8});
}

}  // namespace exsect::reported_scenes_test
