#include "answer/finished_result.h"

#include "support/catch.h"

using namespace exsect;

namespace {

const ParameterBox kPlace = {{{0, 1}, {Rational(1, 2), Rational(1, 2)}, {0, 1}, {0, 1}}};

Node isolated() {
  Node node{};
  node.kinds = {NodeKind::touch};
  for (RationalInterval& i : node.box) i = {Rational(1, 2), Rational(1, 2)};
  node.approx = {0.5, 0.5, 0.5, 0.5};
  return node;
}

}  // namespace

TEST_CASE("finished result: the status follows from what is not decided") {
  GraphBuilder graph;
  graph.add_isolated(graph.add_node(isolated()));
  Work work;
  work.steps["tubes"] = 3;
  const IntersectResult complete = finished(graph, {}, {}, work);
  CHECK(complete.status == Status::complete);
  CHECK(complete.graph.nodes.size() == 1);
  CHECK(complete.work.steps.at("tubes") == 3);
  const IntersectResult open = finished(graph, {}, {{kPlace, "a reason"}});
  CHECK(open.status == Status::incomplete);
  REQUIRE(open.incomplete.size() == 1);
  CHECK(open.incomplete[0].why == "a reason");
  graph.add_isolated(graph.add_node(isolated()));
  const IntersectResult violated = finished(graph, {}, {});
  CHECK(violated.status == Status::incomplete);
  REQUIRE(violated.incomplete.size() == 1);
  CHECK(violated.incomplete[0].why == "two nodes for one point");
  CHECK(violated.incomplete[0].where == isolated().box);
}
