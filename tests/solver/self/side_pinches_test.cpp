#include "self/side_pinches.h"

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::side_pinches_test {
namespace {

using random_nets::Generator;

/// On the side u = 0 the cubic with the control points 0, (2,1,0), (2,-1,0)... turns at v = 1/2 in a cusp.
RationalPatch with_cusp(Generator& generator) {
  random_nets::Net net = random_nets::doubles(generator, 3, 3);
  net[0] = {{0, 0, 0}, {2, 1, 1}, {1, 2, 0}, {3, 3, 1}};
  return RationalPatch(net);
}

bool has(const std::vector<SidePinch>& found, std::size_t fixed, int value, const Rational& at, bool along) {
  return std::ranges::any_of(found, [&](const SidePinch& p) {
    return p.fixed == fixed && p.value == value && p.at == RealAlgebraic(at) && p.along == along;
  });
}

}  // namespace

TEST_CASE("side pinches: cusps of sides, corners, and images") {
  Generator generator(3);
  const RationalPatch x = with_cusp(generator);
  // x_v = 3/4 (P3 + P2 - P1 - P0) at v = 1/2.
  random_nets::Net net(4, std::vector<Point>(4));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = x.point(i, j);
  net[0][3] = net[0][0] + net[0][1] - net[0][2];
  const RationalPatch cusp(net);
  CHECK(has(side_pinches(cusp), 0, 0, Rational(1, 2), true));
  CHECK(has(side_pinches(cusp.transposed()), 1, 0, Rational(1, 2), true));
  CHECK(has(side_pinches(cusp.restricted_to(1, 0, 0, Rational(3, 4))), 0, 1, Rational(2, 3), true));
  CHECK(has(side_pinches(random_nets::image(cusp, random_nets::projective_map(generator))), 0, 0,
            Rational(1, 2), true));
  net[0][3] = {3, 3, 1};
  net[3][2] = net[3][3];  // x_v = 0 in the corner (1,1)
  const auto corner = side_pinches(RationalPatch(net));
  CHECK(has(corner, 0, 1, 1, true));
  CHECK(has(corner, 1, 1, 1, false));
  CHECK(side_pinches(RationalPatch(random_nets::doubles(generator, 3, 2))).empty());
  net[1] = net[0];  // the whole side u = 0, x_u = 0
  CHECK_FALSE(std::ranges::any_of(side_pinches(RationalPatch(net)),
                                  [](const SidePinch& p) { return p.fixed == 0 && p.value == 0; }));
}

TEST_CASE("side pinches: which rectangles contain one with an irrational parameter") {
  const SidePinch pinch{1, 1, real_roots(Polynomial{-1, 0, 2}, 0, 1).front(), false};
  CHECK(contains({{Rational(7, 10), Rational(71, 100)}, {Rational(1, 2), 1}}, pinch));
  CHECK_FALSE(contains({{Rational(7, 10), Rational(707, 1000)}, {Rational(1, 2), 1}}, pinch));
  CHECK_FALSE(contains({{Rational(7, 10), Rational(71, 100)}, {0, Rational(1, 2)}}, pinch));
}

}  // namespace exsect::side_pinches_test
