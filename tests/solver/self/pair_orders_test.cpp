// Self-intersections as graphs of unordered pairs: arcs that end in one pair share its node.
#include "self/pair_orders.h"

#include <exsect/solver/self_intersect.h>

#include <algorithm>

#include "self/chart.h"
#include "support/catch.h"

namespace exsect::pair_orders_test {
namespace {

/// The pair (a, b, c, d) as a node.
Node node_at(int a, int b, int c, int d) {
  Node node{};
  const std::array<int, 4> at = {a, b, c, d};
  for (std::size_t j = 0; j < 4; ++j) {
    node.box[j] = {Rational(at[j], 16), Rational(at[j], 16)};
    node.approx[j] = at[j] / 16.0;
  }
  return node;
}

Arc arc_between(const GraphBuilder& graph, int from, int to) {
  Arc arc{};
  arc.from = from;
  arc.to = to;
  for (const int end : {from, to}) arc.polyline.push_back({graph.node(end).approx, {}});
  return arc;
}

/// Whether all arcs end at the parameters of their nodes.
bool fit_their_nodes(const GraphBuilder& graph) {
  return std::ranges::all_of(graph.arcs(), [&](const Arc& arc) {
    return arc.polyline.front().parameters == graph.node(arc.from).approx &&
           arc.polyline.back().parameters == graph.node(arc.to).approx;
  });
}

std::size_t nodes_used(const GraphBuilder& graph) {
  std::vector<int> ids;
  for (const Arc& arc : graph.arcs()) ids.insert(ids.end(), {arc.from, arc.to});
  std::ranges::sort(ids);
  return static_cast<std::size_t>(std::ranges::unique(ids).begin() - ids.begin());
}

}  // namespace

TEST_CASE("arcs that end in one pair in different orders share a node") {
  GraphBuilder graph;
  // The first four are two pairs in both orders, then a pair of equal points and two others.
  graph.add_node(node_at(0, 1, 2, 3));
  graph.add_node(node_at(2, 3, 0, 1));
  graph.add_node(node_at(0, 5, 6, 7));
  graph.add_node(node_at(6, 7, 0, 5));
  const int cusp = graph.add_node(node_at(8, 8, 8, 8));
  const int a = graph.add_node(node_at(9, 8, 1, 4)), b = graph.add_node(node_at(3, 4, 5, 9));
  graph.add_arc(arc_between(graph, a, 0));
  graph.add_arc(arc_between(graph, 1, 2));  // in the other order, and so is what follows
  graph.add_arc(arc_between(graph, 2, cusp));
  graph.add_arc(arc_between(graph, 3, b));  // and in this one again
  join_orders(graph, {1, 0, 3, 2});
  CHECK(graph.arcs().size() == 4);
  CHECK(nodes_used(graph) == 5);
  CHECK(fit_their_nodes(graph));
  const std::vector<Arc>& arcs = graph.arcs();
  CHECK(arcs[0].to == arcs[1].from);
  CHECK(arcs[1].to == arcs[3].from);
  CHECK(arcs[2].to == cusp);
}

TEST_CASE("a curve that returns to a pair in the other order keeps both nodes") {
  GraphBuilder graph;
  graph.add_node(node_at(0, 1, 2, 3));
  graph.add_node(node_at(2, 3, 0, 1));
  const int a = graph.add_node(node_at(9, 8, 1, 4));
  graph.add_arc(arc_between(graph, 0, a));
  graph.add_arc(arc_between(graph, a, 1));
  join_orders(graph, {1, 0});
  CHECK(nodes_used(graph) == 3);
  CHECK(fit_their_nodes(graph));
}

TEST_CASE("a folded side and a curve that end in one pair are one component") {
  // Along v = 1 the patch is a folded line; its last pair is that of the corners.
  using Row = std::array<Point, 3>;
  const BezierPatch x(ControlNet{Row{Point{0, 1, 0}, Point{1, 1, -1}, Point{-1, 1, 1}},
                                 Row{Point{0, 0, 1}, Point{0, 1, -1}, Point{0, 1, 1}},
                                 Row{Point{0, 1, -1}, Point{1, 1, 1}, Point{-1, 1, 1}}});
  for (const BezierPatch& patch : {x, x.exchanged(), x.reversed_first()}) {
    IntersectOptions options;
    options.tolerance = 1e-3;
    const IntersectResult all = self_intersect(patch, options);
    REQUIRE(all.status == Status::complete);
    CHECK(all.graph.count(ComponentShape::open) == 4);
    CHECK(all.graph.components.size() == 4);
    CHECK(all.graph.boundary_points() == 7);
    options.turning = {Parameter::u, Parameter::u};
    const IntersectResult in_u = self_intersect(patch, options);
    CHECK(in_u.status == Status::complete);
    CHECK(in_u.graph.turning_points(Parameter::u) == all.graph.turning_points(Parameter::u));
    for (const Parameter p : {Parameter::v, Parameter::r, Parameter::s})
      CHECK(in_u.graph.turning_points(p) == 0);
    CHECK(in_u.graph.components.size() == 4);
  }
}

}  // namespace exsect::pair_orders_test
