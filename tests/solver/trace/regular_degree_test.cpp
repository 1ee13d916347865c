#include "trace/regular_degree.h"

#include <exsect/solver/intersect.h>

#include "answer/graph_invariant.h"
#include "support/catch.h"
#include "support/graph_patches.h"
#include "support/random_pairs.h"

namespace exsect::regular_degree_test {
using exsect::testing::graph_patch;

namespace {

/// The plane (r, s, 0).
BezierPatch ground() { return graph_patch({}); }

/// (u, v, a + b u + c v), which meets the ground over the line a + b u + c v = 0.
BezierPatch plane(const Rational& a, const Rational& b, const Rational& c) {
  return graph_patch({{{a, c, 0}, {b, 0, 0}, {0, 0, 0}}});
}

Node node_at(const Rational& u, const Rational& v) {
  Node node{};
  const std::array<Rational, 4> at = {u, v, u, v};
  for (const Parameter p : all_parameters) {
    const Rational& t = at[index(p)];
    node.box[index(p)] = {t, t};
    if (t == 0 || t == 1) node.on.push_back({p, t == 0 ? 0 : 1});
  }
  return node;
}

}  // namespace

TEST_CASE("regular degree: lines through sides and corners") {
  const Rational half(1, 2);
  // u + v = 1/2
  const RegularDegree diagonal(plane(-half, 1, 1), ground());
  CHECK(diagonal(node_at(0, half)) == 1);
  CHECK(diagonal(node_at(half, 0)) == 1);
  CHECK(diagonal(node_at(Rational(1, 4), Rational(1, 4))) == 2);
  // u + v = 0 and u + v = 2 meet the square in a corner only, u = v runs through it
  CHECK(RegularDegree(plane(0, 1, 1), ground())(node_at(0, 0)) == 0);
  CHECK(RegularDegree(plane(-2, 1, 1), ground())(node_at(1, 1)) == 0);
  CHECK(RegularDegree(plane(0, 1, -1), ground())(node_at(0, 0)) == 1);
  CHECK(RegularDegree(plane(0, 1, -1), ground())(node_at(1, 1)) == 1);
  // u = 0 is a side
  CHECK(!RegularDegree(plane(0, 1, 0), ground())(node_at(0, half)));
  CHECK(!RegularDegree(plane(0, 1, 0), ground())(node_at(0, 0)));
  // planes that agree
  CHECK(!RegularDegree(plane(0, 0, 0), ground())(node_at(half, half)));
}

TEST_CASE("regular degree: a curve that touches a side, free parameters and wide boxes") {
  // u = (v - 1/2)^2
  const RegularDegree parabola(graph_patch({{{Rational(-1, 4), 1, -1}, {1, 0, 0}, {0, 0, 0}}}), ground());
  Node node = node_at(0, Rational(1, 2));
  CHECK(!parabola(node));
  node = node_at(Rational(1, 4), 0);
  CHECK(parabola(node) == 1);
  node.free = {Parameter::u};
  CHECK(!parabola(node));
  node = node_at(Rational(1, 16), Rational(1, 4));
  CHECK(parabola(node) == 2);
  node.on = {{Parameter::u, 0}};
  CHECK(parabola(node) == 1);
  node.box[1] = {0, 1};
  CHECK(!parabola(node));  // v turns somewhere in the box
}

TEST_CASE("regular degree: as many arcs as the graphs of random pairs have") {
  int known = 0;
  int unknown = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    const auto pair = seed % 2 == 0 ? random_pairs::scattered(generator) : random_pairs::doubles(generator);
    const IntersectionGraph graph = intersect(pair.x, pair.y).graph;
    const std::vector<int> counted = degrees(graph);
    const RegularDegree degree(pair.x, pair.y);
    for (const Node& node : graph.nodes) {
      const auto expected = degree(node);
      if (expected) CHECK(*expected == counted[static_cast<std::size_t>(node.id)]);
      ++(expected ? known : unknown);
    }
  }
  CHECK(known > 100);
  CHECK(unknown == 0);
}

}  // namespace exsect::regular_degree_test
