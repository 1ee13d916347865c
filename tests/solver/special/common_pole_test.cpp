// Common poles: cones by their directions, cups and saddles by their curvatures.
#include "special/common_pole.h"

#include <vector>

#include "support/catch.h"

namespace exsect::common_pole_test {
namespace {

/// The cone a (1 - t, t, 0) + a t (1 - t) (0,0,2 wave) + a slope (0,0,1).
RationalPatch cone(const Rational& wave, const Rational& slope) {
  const Point o = {0, 0, 0};
  return RationalPatch(
      {{o, o, o}, {{1, 0, slope}, {Rational(1, 2), Rational(1, 2), slope + wave}, {0, 1, slope}}});
}

/// a (1 - t, t, 0) + a^2 (0, 0, p (1 - t)^2 + 2 q t (1 - t) + r t^2): over (x,y) the height p x^2 + 2 q x y +
/// r y^2.
RationalPatch cup(const Rational& p, const Rational& q, const Rational& r) {
  const Rational h(1, 2);
  const Point o = {0, 0, 0};
  return RationalPatch(
      {{o, o, o}, {{h, 0, 0}, {h * h, h * h, 0}, {0, h, 0}}, {{1, 0, p}, {h, h, q}, {0, 1, r}}});
}

bool meet(const RationalPatch& x, const RationalPatch& y) {
  REQUIRE(have_common_pole(x, y));
  const bool alone = meet_in_pole_alone(x, y, Rational(1, 64));
  CHECK(alone == meet_in_pole_alone(y, x, Rational(1, 64)));
  return !alone;
}

}  // namespace

TEST_CASE("common_pole: cones meet in it alone if they have no direction in common") {
  CHECK(!meet(cone(0, 0), cone(0, 1)));
  CHECK(!meet(cone(1, 0), cone(1, Rational(1, 8))));
  CHECK(meet(cone(0, 0), cone(0, 0)));
  CHECK(meet(cone(1, 0), cone(0, Rational(1, 3))));   // where 2 t (1 - t) = 1/3
  CHECK(!meet(cone(1, 0), cone(0, Rational(2, 3))));  // 2/3 > 1/2
  CHECK(meet(cone(1, 0), cone(0, 0)));                // at the ends
  const RationalPatch opposite({{{0, 0, 0}, {0, 0, 0}}, {{-1, 0, 0}, {0, -1, 0}}});
  CHECK(!meet(cone(0, 0), opposite));
}

TEST_CASE("common_pole: cups meet in it alone if their difference is definite over the quadrant") {
  CHECK(!meet(cup(1, 0, 1), cup(2, 0, 2)));
  CHECK(!meet(cup(1, 0, 1), cup(-1, 0, -1)));
  CHECK(!meet(cup(1, 0, 1), cup(2, Rational(1, 2), 3)));
  CHECK(meet(cup(1, 0, 1), cup(2, -1, 2)));  // (x - y)^2: along a line
  CHECK(meet(cup(1, 0, 1), cup(2, 0, 0)));   // x^2 - y^2
  CHECK(meet(cup(1, 0, 1), cup(1, 0, 2)));   // y^2: along the side
  CHECK(meet(cup(1, 0, 1), cup(1, 0, 1)));
}

TEST_CASE("common_pole: patches that come back to the pole, or have it not in common") {
  // y passes through the pole of x again, at the other side.
  const Point o = {0, 0, 0};
  const RationalPatch again({{o, o}, {{0, 0, 2}, {0, 1, 2}}, {{0, 0, -1}, {0, 0, 0}}});
  CHECK(!meet_in_pole_alone(cone(0, 0), again, Rational(1, 64)));
  CHECK(!have_common_pole(cone(0, 0), RationalPatch({{o, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}}})));
  const Point off = {0, 0, power_of_two(-300)};
  CHECK(!have_common_pole(cone(0, 0), RationalPatch({{off, off}, {{0, 0, 1}, {0, 1, 1}}})));
}

}  // namespace exsect::common_pole_test
