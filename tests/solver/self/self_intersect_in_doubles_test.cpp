// Patches of every kind against themselves: biquadratic ones have the answer of the exact solution, as they
// are and as images under projective maps; known loops; maps of the parameters.
#include "self_in_doubles.h"

namespace exsect::self_intersect_in_doubles_test {
namespace {

using namespace self_in_doubles;

BezierPatch doubles(Generator& generator) {
  ControlNet net;
  for (auto& row : net)
    for (Point& p : row)
      for (Rational& c : p) c = from_double(static_cast<double>(generator() >> 11U) * 0x1p-53);
  return BezierPatch(net);
}

/// (0,0), (3,2), (-2,2), (1,0), which crosses itself once.
constexpr std::array<std::array<int, 2>, 4> kLoop = {{{0, 0}, {3, 2}, {-2, 2}, {1, 0}}};

/// The loop moved along a curve that bends in three directions, and widened on its way by `growth` sixths.
RationalPatch swept_loop(int degree, int growth) {
  std::vector<std::vector<Point>> net(4);
  for (std::size_t i = 0; i < 4; ++i)
    for (int j = 0; j <= degree; ++j) {
      const Rational scale = 1 + Rational(growth * j, 6);
      net[i].push_back(
          {scale * kLoop[i][0] + Rational(j * j, 5), scale * kLoop[i][1] - Rational(j, 7), Rational(2 * j)});
    }
  return RationalPatch(net);
}

}  // namespace

TEST_CASE("self in doubles: random biquadratic patches as the exact solution has them") {
  for (std::uint64_t seed = 2; seed <= 7; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const BezierPatch x = scattered(generator);
    check_same(in_doubles(x), self_intersect(x).graph);
  }
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    INFO("53 bits, seed " << seed);
    Generator generator(seed);
    const BezierPatch x = doubles(generator);
    check_same(in_doubles(x), self_intersect(x).graph);
  }
}

TEST_CASE(
    "self in doubles: images under projective maps, and other parameters, meet themselves in the same "
    "pairs") {
  Generator generator(20);
  const BezierPatch x = doubles(generator);
  const IntersectionGraph expected = self_intersect(x).graph;
  REQUIRE_FALSE(expected.arcs.empty());
  check_same(self_intersect(random_nets::image(x, random_nets::projective_map(generator))), expected);
  check_same(in_doubles(x.exchanged()), expected, {{1, 0, 3, 2}, {}});
}

TEST_CASE("self in doubles: a loop that is swept crosses itself along one curve") {
  for (const int growth : {0, 1})
    for (const int degree : {1, 2, 3}) {
      INFO("degree " << degree << ", growth " << growth);
      const IntersectResult result = self_intersect(swept_loop(degree, growth));
      check_complete(result);
      CHECK(result.graph.count(ComponentShape::open) == 1);
      CHECK(result.graph.components.size() == 1);
      CHECK(result.graph.boundary_points() == 2);
      // The double point of the loop is at t = 1/2 -+ sqrt(3)/4.
      for (const Arc& arc : result.graph.arcs)
        for (const PolylineVertex& vertex : arc.polyline) {
          const auto [least, most] = std::minmax(vertex.parameters[0], vertex.parameters[2]);
          CHECK(std::fabs(least + most - 1) < 1e-9);
          CHECK(std::fabs(vertex.parameters[1] - vertex.parameters[3]) < 1e-9);
        }
    }
}

TEST_CASE("self in doubles: a swept loop under a projective map has the same curve") {
  Generator generator(3);
  const RationalPatch x = swept_loop(2, 1);
  const RationalPatch image = random_nets::image(x, random_nets::projective_map(generator));
  REQUIRE_FALSE(image.is_polynomial());
  check_same(self_intersect(image), self_intersect(x).graph);
}

TEST_CASE(
    "self in doubles: biquadratic patches with a side that is one point as the exact solution has them") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    ControlNet net = scattered(generator).net();
    const Point pole = scattered(generator).net()[0][0];
    const std::size_t side = seed % 4 < 2 ? 0 : 2;
    for (std::size_t k = 0; k < 3; ++k) (seed % 2 == 0 ? net[side][k] : net[k][side]) = pole;
    const BezierPatch x(net);
    check_same(in_doubles(x), self_intersect(x).graph);
  }
}

TEST_CASE("self in doubles: patches that are injective, of every kind") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_nets::Nets nets = random_nets::crossing(generator, {3, 2, 3, 3}, true);
    for (const RationalPatch& x : {nets.first(), nets.second(), random_nets::weighted(generator, nets.x)}) {
      const IntersectResult result = self_intersect(x);
      check_complete(result);
      CHECK(result.graph.nodes.empty());
    }
  }
}

TEST_CASE("self in doubles: a patch that covers its image twice is said to") {
  random_nets::Net net(4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j)
      net[static_cast<std::size_t>(i)].push_back({i * (3 - i), j, i * (3 - i) * j + j});
  const IntersectResult result = self_intersect(RationalPatch(net, {{1, 2}, {2, 1}, {2, 1}, {1, 2}}));
  CHECK(result.status == Status::incomplete);
  REQUIRE(result.incomplete.size() == 1);
  CHECK(result.incomplete[0].why ==
        "the patch covers its image more than once: (u, v) and (1 - u, v) are one point; its other pairs are "
        "not "
        "decided");
}

TEST_CASE("self in doubles: what is not decided is incomplete, and exact needs a biquadratic patch") {
  const RationalPatch loop = swept_loop(2, 0);
  IntersectOptions options;
  options.exact = true;
  CHECK_THROWS_AS(self_intersect(loop, options), NotSupported);
  // A cubic with a cusp, swept: not even the cuspidal line is a pinch point.
  const RationalPatch cuspidal(
      {{{0, 0, 0}, {0, 0, 1}}, {{1, 1, 0}, {1, 1, 1}}, {{0, 1, 0}, {0, 1, 1}}, {{1, 0, 0}, {1, 0, 1}}});
  const IntersectResult result = self_intersect(cuspidal);
  CHECK(result.status == Status::incomplete);
  CHECK(result.graph.nodes.empty());
  CHECK_FALSE(result.incomplete.empty());
}

}  // namespace exsect::self_intersect_in_doubles_test
