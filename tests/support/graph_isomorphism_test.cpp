#include "support/graph_isomorphism.h"

#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>

#include <algorithm>

#include "support/catch.h"

namespace exsect::graph_isomorphism_test {
namespace {

IntersectionGraph first_example() {
  const auto file = read_patches(EXSECT_EXAMPLES "/chapter9-first.json");
  return intersect(file.patches.at(0).patch, file.patches.at(1).patch).graph;
}

}  // namespace

TEST_CASE("graph isomorphism: a graph equals itself in any order of nodes") {
  const IntersectionGraph graph = first_example();
  CHECK(difference(graph, graph, {}) == "");
  IntersectionGraph reordered = graph;
  std::reverse(reordered.nodes.begin(), reordered.nodes.end());
  for (Arc& arc : reordered.arcs) std::swap(arc.from, arc.to);
  CHECK(difference(graph, reordered, {}) == "");
}

TEST_CASE("graph isomorphism: every kind of change is noticed") {
  const IntersectionGraph graph = first_example();
  CHECK(difference(graph, graph, {{1, 0, 2, 3}, {}}) != "");
  CHECK(difference(graph, graph, {{0, 1, 2, 3}, {true, false, false, false}}) != "");

  const auto changed = [&](auto change) {
    IntersectionGraph other = graph;
    change(other);
    return difference(graph, other, {});
  };
  CHECK(changed([](auto& g) { g.nodes.pop_back(); }) != "");
  CHECK(changed([](auto& g) { g.nodes.at(0).kinds = {NodeKind::cusp}; }) != "");
  CHECK(changed([](auto& g) { g.nodes.at(0).on.push_back({Parameter::r, 1}); }) != "");
  CHECK(changed([](auto& g) { g.nodes.at(0).wrt.push_back(Parameter::v); }) != "");
  CHECK(changed([](auto& g) { g.nodes.at(0).box[0] = {Rational(7), Rational(8)}; }) != "");
  CHECK(changed([](auto& g) { std::swap(g.arcs.at(0).polyline, g.arcs.at(1).polyline); }) != "");
  CHECK(changed([](auto& g) { std::swap(g.arcs.at(0).to, g.arcs.at(3).to); }) != "");
  CHECK(changed([](auto& g) { g.arcs.at(0).contact = Contact::tangential; }) != "");
  CHECK(changed([](auto& g) { g.components.at(0).shape = ComponentShape::branched; }) != "");
  CHECK(changed([](auto& g) { g.isolated_points.push_back(0); }) != "");
}

}  // namespace exsect::graph_isomorphism_test
