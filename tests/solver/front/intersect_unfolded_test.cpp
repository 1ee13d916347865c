// Pairs in terms of the squares that their patches depend on, against the solution in doubles, which does not
// look for squares.
#include "intersect_unfolded.h"

#include <algorithm>

#include "filter/filter.h"
#include "special/unfolded_parameters.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/graph_patches.h"
#include "support/random_pairs.h"

namespace exsect::intersect_unfolded_test {
namespace {

using random_pairs::Generator;
using random_pairs::Pair;

/// The patch whose middle row is that at `t` between the outer ones.
BezierPatch at_one_speed(const BezierPatch& x, const Rational& t) {
  ControlNet net = x.net();
  for (std::size_t j = 0; j < 3; ++j) net[1][j] = net[0][j] + t * (net[2][j] - net[0][j]);
  return BezierPatch(net);
}

/// Run through with speeds other than 1/2: x along u, y along s.
Pair two_speeds(Generator& generator) {
  const Pair pair = random_pairs::small_rationals(generator);
  const auto speed = [&] {
    const Rational t(random_pairs::integer(generator, 1, 7), 16);
    return random_pairs::integer(generator, 0, 1) == 0 ? t : Rational(1 - t);
  };
  return {at_one_speed(pair.x, speed()), at_one_speed(pair.y.exchanged(), speed()).exchanged()};
}

/// (r², s², 0)
BezierPatch plane_of_squares() {
  ControlNet c{};
  c[2][0][0] = 1;
  c[0][2][1] = 1;
  return BezierPatch::from_power_basis(c);
}

}  // namespace

TEST_CASE("a pair without squares, or with one that turns inside, is left alone", "[unfolded_parameters]") {
  Generator generator(3);
  const Pair pair = random_pairs::small_rationals(generator);
  CHECK_FALSE(intersect_unfolded(pair.x, pair.y, {}));
  for (const Rational& t : {Rational(2), Rational(-1, 3), Rational(1, 2)})
    CHECK_FALSE(intersect_unfolded(at_one_speed(pair.x, t), pair.y, {}));
  CHECK_FALSE(intersect_unfolded(at_one_speed(pair.x, 2), at_one_speed(pair.y, 0), {}));
}

TEST_CASE("random pairs with squares are those of the solution in doubles", "[unfolded_parameters]") {
  const unsigned seed = 17;
  INFO("seed " << seed);
  Generator generator(seed);
  int compared = 0;
  for (int i = 0; i < 30; ++i) {
    const Pair pair = two_speeds(generator);
    const auto direct = intersect_filtered(pair.x, pair.y, {});
    if (!direct) continue;
    INFO("pair " << i);
    const auto unfolded = intersect_unfolded(pair.x, pair.y, {});
    REQUIRE(unfolded);
    REQUIRE(unfolded->status == Status::complete);
    CHECK(difference(unfolded->graph, direct->graph, {}) == "");
    ++compared;
  }
  CHECK(compared > 20);
}

TEST_CASE("what lies along a side on which a patch is singular", "[unfolded_parameters]") {
  // u (v - 1/2 + u): the side u = 0, and an arc that leaves it at v = 1/2, or s = sqrt(1/2).
  const BezierPatch x = testing::graph_patch({{{0, 0, 0}, {Rational(-1, 2), 1, 0}, {1, 0, 0}}});
  const auto result = intersect_unfolded(x, plane_of_squares(), {});
  REQUIRE(result);
  CHECK(result->status == Status::complete);
  REQUIRE(result->graph.arcs.size() == 3);
  for (const Arc& arc : result->graph.arcs) {
    const bool on_side = arc.place == ArcPlace::patch_boundary;
    CHECK(arc.contact == (on_side ? Contact::tangential : Contact::transversal));
    for (const PolylineVertex& vertex : arc.polyline)
      if (on_side) CHECK(vertex.parameters[2] == 0);
  }
  CHECK(result->graph.count(ComponentShape::branched) == 1);
  CHECK(std::count_if(result->graph.nodes.begin(), result->graph.nodes.end(), [](const Node& node) {
          return std::count(node.kinds.begin(), node.kinds.end(), NodeKind::crossing) == 1;
        }) == 1);
}

TEST_CASE("an arc that touches a side on which a patch is singular", "[unfolded_parameters]") {
  // u - (v - 1/2)²: in r it is |v - 1/2|, both branches of which end in a singular point.
  const BezierPatch x = testing::graph_patch({{{Rational(-1, 4), 1, -1}, {1, 0, 0}, {0, 0, 0}}});
  const auto result = intersect_unfolded(x, plane_of_squares(), {});
  REQUIRE(result);
  CHECK(result->status == Status::complete);
  REQUIRE(result->graph.nodes.size() == 3);
  for (const Node& node : result->graph.nodes) {
    const bool singular = std::count(node.kinds.begin(), node.kinds.end(), NodeKind::crossing) == 1;
    CHECK(singular == (node.box[0].upper == 0));
  }
}

}  // namespace exsect::intersect_unfolded_test
