// Graphs of curves in space: connected parts, their shape and the order of their arcs.
#include "verify/space_graph.h"

#include <exsect/solver/intersect_equations.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "support/catch.h"

namespace exsect::space_graph_test {
namespace {

/// Arcs between nodes with these numbers, straight, of the nodes (i, i^2, 0).
SurfaceIntersection figure(int nodes, const std::vector<std::array<int, 2>>& arcs) {
  SurfaceIntersection found{Status::complete};
  for (int i = 0; i < nodes; ++i) {
    const Rational x = i, y = i * i;
    found.nodes.push_back(
        {i, SpaceNodeKind::joint, 2, {{{x, x}, {y, y}, {0, 0}}}, {1.0 * i, 1.0 * i * i, 0}});
  }
  for (const auto& [from, to] : arcs)
    found.arcs.push_back({static_cast<int>(found.arcs.size()),
                          0,
                          from,
                          to,
                          1,
                          {found.nodes[static_cast<std::size_t>(from)].approx,
                           found.nodes[static_cast<std::size_t>(to)].approx},
                          0});
  return found;
}

/// Whether every arc but the first shares a node with the one before.
bool is_a_path(const SurfaceIntersection& found, const std::vector<int>& arcs) {
  const auto ends = [&](int id) {
    const SpaceArc& arc = found.arcs[static_cast<std::size_t>(id)];
    return std::array{arc.from, arc.to};
  };
  for (std::size_t k = 0; k + 1 < arcs.size(); ++k) {
    const auto a = ends(arcs[k]), b = ends(arcs[k + 1]);
    if (std::ranges::find_first_of(a, b) == a.end()) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("space graph: a loop at one node, a chain given from its middle, a star and two parallel arcs") {
  const SurfaceIntersection found =
      figure(11, {{0, 0}, {2, 3}, {1, 2}, {4, 3}, {5, 6}, {5, 7}, {8, 5}, {9, 10}, {10, 9}});
  const IntersectionGraph graph = graph_in_space(found).graph;
  REQUIRE(graph.components.size() == 4);
  std::map<std::vector<int>, ComponentShape> shapes;
  for (const Component& part : graph.components) {
    std::vector<int> arcs = part.arcs;
    if (part.shape != ComponentShape::branched) CHECK(is_a_path(found, arcs));
    std::ranges::sort(arcs);
    shapes[arcs] = part.shape;
    for (const int arc : arcs) CHECK(graph.arcs[static_cast<std::size_t>(arc)].component == part.id);
  }
  CHECK(shapes[{0}] == ComponentShape::closed);
  CHECK(shapes[{1, 2, 3}] == ComponentShape::open);
  CHECK(shapes[{4, 5, 6}] == ComponentShape::branched);
  CHECK(shapes[{7, 8}] == ComponentShape::closed);
}

TEST_CASE("space graph: random polygons and chains, shuffled, are run through in order") {
  std::mt19937 generator(11);
  for (int k = 0; k < 100; ++k) {
    INFO(k << " of seed 11");
    const int size = 3 + k % 17;
    const bool is_closed = k % 2 == 0;
    std::vector<std::array<int, 2>> arcs;
    for (int i = 0; i < size; ++i) {
      const int next = is_closed ? (i + 1) % size : i + 1;
      arcs.push_back(k % 3 == i % 3 ? std::array{i, next} : std::array{next, i});
    }
    std::ranges::shuffle(arcs, generator);
    const SurfaceIntersection found = figure(size + 1, arcs);
    const IntersectionGraph graph = graph_in_space(found).graph;
    REQUIRE(graph.components.size() == 1);
    CHECK(graph.components[0].shape == (is_closed ? ComponentShape::closed : ComponentShape::open));
    CHECK(graph.components[0].arcs.size() == arcs.size());
    CHECK(is_a_path(found, graph.components[0].arcs));
  }
}

TEST_CASE("space graph: contact, touch points and their bounds, and the extent") {
  const ImplicitSurface tube = ImplicitSurface::cylinder({0, 0, 0}, {0, 0, 1}, 1);
  const IntersectResult around = graph_in_space(intersect(tube, ImplicitSurface::sphere({0, 0, 0}, 1)));
  REQUIRE(!around.graph.arcs.empty());
  for (const Arc& arc : around.graph.arcs) CHECK(arc.contact == Contact::tangential);
  const SurfaceIntersection point = intersect(tube, ImplicitSurface::sphere({2, 0, Rational(1, 3)}, 1));
  CHECK(graph_in_space(point).graph.isolated_points.size() == 1);
  REQUIRE(point_bounds(point).size() == 1);
  CHECK(point_bounds(point)[0] < 1e-12);
  CHECK(point_bounds(point)[0] > 0);  // 1/3 is no double
  CHECK(extent_in_space(point) == 0);
  CHECK(largest_bound(point) == 0);
  const SurfaceIntersection ring = intersect(tube, ImplicitSurface::plane({0, 0, 0}, {0, 0, 1}));
  CHECK(std::abs(extent_in_space(ring) - 2) < 1e-3);
  CHECK(extent_in_space({Status::complete}) == 0);
}

}  // namespace exsect::space_graph_test
