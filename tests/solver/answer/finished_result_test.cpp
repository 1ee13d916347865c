#include "answer/finished_result.h"

#include <stdexcept>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "support/catch.h"

namespace exsect::finished_result_test {

namespace {

const ParameterBox kPlace = {{{0, 1}, {Rational(1, 2), Rational(1, 2)}, {0, 1}, {0, 1}}};

bool same(const ParameterBox& a, const ParameterBox& b) { return lies_in(a, b) && lies_in(b, a); }

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
  CHECK(open.incomplete[0].reason == Reason::not_decided);
  graph.add_isolated(graph.add_node(isolated()));
  const IntersectResult violated = finished(graph, {}, {});
  CHECK(violated.status == Status::incomplete);
  REQUIRE(violated.incomplete.size() == 1);
  CHECK(violated.incomplete[0].why == "two nodes for one point");
  CHECK(violated.incomplete[0].reason == Reason::failed_proof);
  CHECK(same(violated.incomplete[0].where, isolated().box));
}

TEST_CASE("finished result: a failed proof is an incomplete answer with its place") {
  const IntersectResult failed =
      answered(Run(), []() -> IntersectResult { throw ProofFailure(kPlace, "two proofs disagree"); });
  CHECK(failed.status == Status::incomplete);
  CHECK(failed.graph.nodes.empty());
  REQUIRE(failed.incomplete.size() == 1);
  CHECK(same(failed.incomplete[0].where, kPlace));
  CHECK(failed.incomplete[0].why == "two proofs disagree");
  CHECK(failed.incomplete[0].reason == Reason::failed_proof);
  const IntersectResult other =
      answered(Run(), []() -> IntersectResult { throw std::domain_error("no carrier"); });
  REQUIRE(other.incomplete.size() == 1);
  CHECK(other.incomplete[0].why == "a proof failed: no carrier");
  CHECK(other.incomplete[0].where[1].lower == 0);
}

TEST_CASE("finished result: what the caller does wrong, or stops, is thrown on") {
  CHECK_THROWS_AS(answered(Run(), []() -> IntersectResult { throw std::invalid_argument("tolerance"); }),
                  std::invalid_argument);
  CHECK_THROWS_AS(answered(Run(), []() -> IntersectResult { throw std::runtime_error("stopped"); }),
                  std::runtime_error);
  CHECK(failure_of([] { throw std::out_of_range("index"); }) == "a proof failed: index");
  CHECK(!failure_of([] {}));
  CHECK_THROWS_AS(failure_of([] { throw std::invalid_argument("value"); }), std::invalid_argument);
}

}  // namespace exsect::finished_result_test
