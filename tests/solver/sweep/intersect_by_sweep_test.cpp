#include "sweep/intersect_by_sweep.h"

#include "support/families.h"
#include "support/known_curves.h"
#include "support/random_pairs.h"

namespace exsect::intersect_by_sweep_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

IntersectResult swept(const BezierPatch& x, const BezierPatch& y, const IntersectOptions& options = {}) {
  ExactPair pair(x, y);
  return intersect_by_sweep(x, y, Run(options), pair);
}

}  // namespace

TEST_CASE("intersect by sweep: curves with closed formulas", "[sweep]") {
  for (const auto& [h, closed] :
       {std::pair(kCircle, true), std::pair(kHyperbola, false), std::pair(kParabola, false)}) {
    const IntersectResult result = swept(graph_patch(h), plane_patch());
    CHECK(result.incomplete.empty());
    REQUIRE(result.graph.components.size() == 1);
    CHECK((result.graph.components[0].shape == ComponentShape::closed) == closed);
  }
}

TEST_CASE("intersect by sweep: special positions, against their exact graphs", "[sweep]") {
  const std::vector<ExactCase> cases = {
      families::crossing(families::Plane::square), families::irrational_lines(families::Plane::square),
      families::tangent_curve(q(1, 3), families::Plane::square), families::line_and_arc()};
  for (const ExactCase& c : cases) {
    INFO(c.name);
    IntersectOptions options;
    options.turning = c.turning;
    CHECK(difference(swept(c.x, c.y, options), c) == "");
  }
}

TEST_CASE("intersect by sweep: the same graph with the patches exchanged", "[sweep]") {
  const unsigned seed = 20305;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int round = 0; round < 3; ++round) {
    const auto [x, y] = random_pairs::scattered(generator);
    const IntersectResult one = swept(x, y), other = swept(y, x);
    CHECK(one.incomplete.empty());
    CHECK(other.incomplete.empty());
    CHECK(one.graph.components.size() == other.graph.components.size());
    CHECK(one.graph.nodes.size() == other.graph.nodes.size());
    CHECK(one.graph.arcs.size() == other.graph.arcs.size());
  }
}

TEST_CASE("intersect by sweep: a side between two arcs is the middle of their curve", "[sweep]") {
  // u (u - 8 v (1 - v)): the side u = 0, and from both its ends arcs to u = 1.
  const Terms h = Terms{{{1, 0}, 1}} * (Terms{{{1, 0}, 1}} + Terms{{{0, 1}, -8}, {{0, 2}, 8}});
  const IntersectResult result = swept(graph(h), plane({-1, -1, 0}, {3, 0, 0}, {0, 3, 0}));
  CHECK(result.incomplete.empty());
  REQUIRE(result.graph.components.size() == 1);
  const Component& curve = result.graph.components[0];
  CHECK(curve.shape == ComponentShape::open);
  REQUIRE(curve.arcs.size() == 3);
  const auto place = [&](std::size_t i) {
    return result.graph.arcs[static_cast<std::size_t>(curve.arcs[i])].place;
  };
  CHECK(place(0) == ArcPlace::interior);
  CHECK(place(1) == ArcPlace::patch_boundary);
  CHECK(place(2) == ArcPlace::interior);
}

TEST_CASE("intersect by sweep: without time it is incomplete, and says so", "[sweep]") {
  IntersectOptions options;
  options.max_seconds = 1e-9;
  const IntersectResult result = swept(graph_patch(kCircle), plane_patch(), options);
  CHECK_FALSE(result.incomplete.empty());
}

TEST_CASE("intersect by sweep: a curve that runs into a common pole is soon left open", "[sweep]") {
  // (a (1 - t), a t, a^2 (1 - t)^2) and (b (1 - s), b s, b^2 s^2) meet where a = b, t = s = 1/2; tracing ends
  // at a = 0, in balls of any number of bits.
  const auto cup = [](std::size_t high) {
    ControlNet net;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        net[i][j] = {Rational(i * (2 - j), 4), Rational(i * j, 4), i == 2 && j == high ? 1 : 0};
    return BezierPatch(net);
  };
  IntersectOptions options;
  options.max_seconds = 20;  // twice as much were not enough in 1024 bits
  const IntersectResult result = swept(cup(0), cup(2), options);
  REQUIRE(result.incomplete.size() == 1);
  CHECK(result.incomplete[0].reason == Reason::not_decided);
  CHECK(result.incomplete[0].where[0].lower == 0);
  CHECK(result.incomplete[0].where[2].lower == 0);
}

}  // namespace exsect::intersect_by_sweep_test
