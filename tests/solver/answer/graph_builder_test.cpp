#include "answer/graph_builder.h"

#include <cmath>
#include <utility>
#include <vector>

#include "support/catch.h"

namespace exsect::graph_builder_test {

namespace {

/// A point inside all squares.
Node node_at(double t) {
  Node node{};
  const Rational at = from_double(t);
  node.box = {{{at, at}, {at, at}, {at, at}, {at, at}}};
  node.approx = {t, t, t, t};
  return node;
}

Arc arc_between(const GraphBuilder& graph, int from, int to) {
  Arc arc{};
  arc.id = 77;
  arc.component = 78;
  arc.from = from;
  arc.to = to;
  arc.polyline = {{graph.node(from).approx, {}}, {graph.node(to).approx, {}}};
  return arc;
}

GraphBuilder with_nodes(int count) {
  GraphBuilder graph;
  for (int i = 0; i < count; ++i) CHECK(graph.add_node(node_at(i / 16.0)) == i);
  return graph;
}

std::vector<ComponentShape> shapes(const IntersectionGraph& graph) {
  std::vector<ComponentShape> result;
  for (const Component& component : graph.components) result.push_back(component.shape);
  return result;
}

}  // namespace

TEST_CASE("graph builder: arcs of paths and loops come in order along the curve") {
  using Ends = std::vector<std::pair<int, int>>;
  const auto ordered = [](const Ends& ends) {
    GraphBuilder graph = with_nodes(6);
    for (const auto& [from, to] : ends) graph.add_arc(arc_between(graph, from, to));
    const IntersectionGraph made = std::move(graph).finish({}).graph;
    REQUIRE(made.components.size() == 1);
    return made.components[0].arcs;
  };
  // The path 2 0 1 3, whose middle arc, on a side, was added first; and as it was added where that is an
  // order.
  CHECK(ordered({{0, 1}, {2, 0}, {3, 1}}) == std::vector{1, 0, 2});
  CHECK(ordered({{1, 0}, {1, 2}, {3, 2}}) == std::vector{0, 1, 2});
  CHECK(ordered({{2, 3}, {1, 2}, {0, 1}}) == std::vector{0, 1, 2});
  CHECK(ordered({{3, 4}, {0, 1}, {1, 2}, {2, 3}, {4, 5}}) == std::vector{1, 2, 3, 0, 4});
  // The loop 0 1 2 3 0.
  CHECK(ordered({{0, 1}, {2, 3}, {2, 1}, {3, 0}}) == std::vector{0, 2, 1, 3});
  CHECK(ordered({{0, 1}, {1, 2}, {2, 3}, {3, 0}}) == std::vector{0, 1, 2, 3});
  CHECK(ordered({{0, 1}, {1, 0}}) == std::vector{0, 1});
}

TEST_CASE("graph builder: components and their shapes") {
  GraphBuilder graph = with_nodes(9);
  const std::vector<std::pair<int, int>> ends = {{0, 1}, {2, 3}, {1, 0}, {3, 4}, {5, 6}, {6, 7}, {8, 6}};
  for (const auto& [from, to] : ends) graph.add_arc(arc_between(graph, from, to));
  const IntersectionGraph made = std::move(graph).finish({}).graph;
  using enum ComponentShape;
  CHECK(shapes(made) == std::vector{closed, open, branched});
  CHECK(made.components[0].arcs == std::vector{0, 2});
  CHECK(made.components[1].arcs == std::vector{1, 3});
  CHECK(made.components[2].arcs == std::vector{4, 5, 6});
  for (std::size_t i = 0; i < made.arcs.size(); ++i) CHECK(made.arcs[i].id == static_cast<int>(i));
  for (const Component& component : made.components)
    for (const int arc : component.arcs)
      CHECK(made.arcs[static_cast<std::size_t>(arc)].component == component.id);
}

TEST_CASE("graph builder: nodes that nothing names are dropped, the others renumbered") {
  GraphBuilder graph = with_nodes(8);
  graph.add_arc(arc_between(graph, 6, 3));
  graph.add_isolated(1);
  graph.add_overlap({{arc_between(graph, 4, 7)}, {arc_between(graph, 7, 4), arc_between(graph, 4, 4)}});
  const auto [made, violations] = std::move(graph).finish({});
  REQUIRE(made.nodes.size() == 5);  // 1, 3, 4, 6, 7
  for (std::size_t i = 0; i < 5; ++i) CHECK(made.nodes[i].id == static_cast<int>(i));
  CHECK(made.nodes[1].approx[0] == 3 / 16.0);
  CHECK(made.arcs[0].from == 3);
  CHECK(made.arcs[0].to == 1);
  CHECK(made.isolated_points == std::vector{0});
  REQUIRE(made.overlaps.size() == 1);
  const auto& chains = made.overlaps[0].chains;
  CHECK(chains[0][0].to == 4);
  CHECK(chains[1][1].id == 2);
  CHECK(chains[1][0].component == -1);
}

TEST_CASE("graph builder: nodes become one, arcs are taken away") {
  GraphBuilder graph = with_nodes(5);
  graph.add_arc(arc_between(graph, 0, 1));
  graph.add_arc(arc_between(graph, 2, 3));
  graph.add_isolated(4);
  graph.contract({1, 2, 4}, node_at(0.75));
  CHECK(graph.arcs()[0].to == 5);
  CHECK(graph.arcs()[1].from == 5);
  CHECK(graph.isolated_points().empty());
  graph.contract({4}, node_at(0.875));
  CHECK(graph.isolated_points() == std::vector{6});
  const std::vector<Arc> taken = graph.take_arcs(1);
  REQUIRE(taken.size() == 1);
  CHECK(taken[0].to == 3);
  CHECK(graph.arcs().size() == 1);
}

TEST_CASE("graph builder: a graph taken up again is the same") {
  GraphBuilder graph = with_nodes(3);
  graph.add_arc(arc_between(graph, 0, 2));
  graph.add_isolated(1);
  const IntersectionGraph first = std::move(graph).finish({}).graph;
  const IntersectionGraph again = GraphBuilder(first).finish({}).graph;
  CHECK(again.nodes.size() == first.nodes.size());
  CHECK(again.components.size() == 1);
  CHECK(again.components[0].arcs == first.components[0].arcs);
  CHECK(again.isolated_points == first.isolated_points);
}

TEST_CASE("graph builder: what names no node is dropped, which is a violation") {
  for (const int id : {-1, 2}) {
    GraphBuilder graph = with_nodes(2);
    graph.add_arc(arc_between(graph, 0, 1));
    Arc dangling = arc_between(graph, 0, 1);
    dangling.to = id;
    graph.add_arc(dangling);
    graph.add_isolated(id);
    const auto [made, violations] = std::move(graph).finish({});
    CHECK(made.arcs.size() == 1);
    CHECK(made.isolated_points.empty());
    REQUIRE(!violations.empty());
    CHECK(violations[0].why == "an arc or an isolated point without a node");
  }
}

}  // namespace exsect::graph_builder_test
