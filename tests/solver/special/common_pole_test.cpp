// Common poles: cones by their directions, cups and saddles by their curvatures.
#include "special/common_pole.h"

#include <exsect/algebra/nearest_double.h>

#include <cmath>
#include <utility>
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

/// b (1 - t, t, 0) + b^2 (0, 0, p (1 - t)^2 + 2 q t (1 - t) + r t^2) with b = speed a: over (x,y) the height
/// p x^2 + 2 q x y + r y^2 for every speed.
RationalPatch cup(const Rational& p, const Rational& q, const Rational& r, const Rational& speed = 1) {
  const Rational h = speed / 2, square = speed * speed;
  const Point o = {0, 0, 0};
  return RationalPatch({{o, o, o},
                        {{h, 0, 0}, {h / 2, h / 2, 0}, {0, h, 0}},
                        {{speed, 0, square * p}, {h, h, square * q}, {0, speed, square * r}}});
}

const std::vector<Parameter> kAll = {Parameter::u, Parameter::v, Parameter::r, Parameter::s};

bool meet(const RationalPatch& x, const RationalPatch& y) {
  REQUIRE(have_common_pole(x, y));
  const auto alone = [](const RationalPatch& a, const RationalPatch& b) {
    const auto arcs = arcs_at_common_pole(a, b, Rational(1, 64), {});
    return arcs && arcs->empty();
  };
  CHECK(alone(x, y) == alone(y, x));
  return !alone(x, y);
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

TEST_CASE("common_pole: cones have their common directions for arcs") {
  // 2 t (1 - t) = slope at the same t of both.
  const RationalPatch x = cone(1, 0);
  for (const auto& [slope, count] :
       {std::pair(Rational(1, 3), std::size_t{2}), std::pair(Rational(-1, 3), std::size_t{0})}) {
    const RationalPatch y = cone(0, slope);
    const auto arcs = arcs_at_common_pole(x, y, Rational(1, 256), kAll);
    REQUIRE(arcs);
    REQUIRE(arcs->size() == count);
    const auto exchanged = arcs_at_common_pole(y, x, Rational(1, 256), kAll);
    REQUIRE(exchanged);
    CHECK(exchanged->size() == count);
    for (std::size_t i = 0; i < count; ++i) {
      const PoleArc& arc = (*arcs)[i];
      const double root = 0.5 + (i == 0 ? -0.5 : 0.5) * std::sqrt(1.0 / 3);
      for (const RationalInterval& at : {arc.along, arc.on_other[1]}) {
        CHECK(to_double(at.lower) < root);
        CHECK(root < to_double(at.upper));
        CHECK(to_double(at.width()) < 0.02);
      }
      CHECK(arc.on_other[0].lower == 0);
      CHECK(arc.on_other[0].upper >= Rational(1, 256));
      CHECK(std::abs(arc.step[0] - (1 - root) / 256) <= arc.bend);
      CHECK(std::abs(arc.step[2] - 1.0 / 768) <= arc.bend);
    }
  }
}

TEST_CASE("common_pole: cups of one tangent plane have arcs where their heights agree") {
  // The difference of the heights, x^2 - 4 y^2 - x y / 3, is 0 in one direction of the quadrant; t is
  // constant.
  const RationalPatch x = cup(1, 0, 1), y = cup(2, Rational(-1, 6), -3);
  const auto arcs = arcs_at_common_pole(x, y, Rational(1, 1024), {Parameter::u, Parameter::r});
  REQUIRE(arcs);
  REQUIRE(arcs->size() == 1);
  const double slope = (1.0 / 3 + std::sqrt(1.0 / 9 + 16)) / 2, root = 1 / (1 + slope);
  CHECK(std::abs(to_double(arcs->front().along.midpoint()) - root) < 0.01);
  CHECK(!arcs_at_common_pole(x, y, Rational(1, 1024), {Parameter::v}));
}

TEST_CASE("common_pole: cups of other speeds have the same arcs") {
  // In a row along the common normal c has the power 2, which for equal speeds, where c is 1, is that of the
  // others.
  const double slope = (1.0 / 3 + std::sqrt(1.0 / 9 + 16)) / 2, root = 1 / (1 + slope);
  for (const Rational& speed : {Rational(1, 2), Rational(1), Rational(2), Rational(3)})
    for (const bool exchanged : {false, true}) {
      CAPTURE(to_double(speed), exchanged);
      const RationalPatch cups[] = {cup(1, 0, 1), cup(2, Rational(-1, 6), -3, speed)};
      const auto arcs =
          arcs_at_common_pole(cups[exchanged ? 1 : 0], cups[exchanged ? 0 : 1], Rational(1, 4096), {});
      REQUIRE(arcs);
      REQUIRE(arcs->size() == 1);
      for (const RationalInterval& at : {arcs->front().along, arcs->front().on_other[1]}) {
        CHECK(to_double(at.lower) < root);
        CHECK(root < to_double(at.upper));
      }
      const Rational ratio = exchanged ? speed : Rational(1) / speed;
      CHECK(arcs->front().on_other[0].upper >= ratio / 4096);
      CHECK(arcs->front().on_other[0].upper <= ratio / 2048);
    }
}

TEST_CASE("common_pole: no answer for a double direction, and for directions of the ends") {
  CHECK(!arcs_at_common_pole(cone(1, 0), cone(0, Rational(1, 2)), Rational(1, 256), {}));
  CHECK(!arcs_at_common_pole(cone(1, 0), cone(0, 0), Rational(1, 256), {}));
}

TEST_CASE("common_pole: patches that come back to the pole, or have it not in common") {
  // y passes through the pole of x again, at the other side.
  const Point o = {0, 0, 0};
  const RationalPatch again({{o, o}, {{0, 0, 2}, {0, 1, 2}}, {{0, 0, -1}, {0, 0, 0}}});
  CHECK(!arcs_at_common_pole(cone(0, 0), again, Rational(1, 64), {}));
  CHECK(!have_common_pole(cone(0, 0), RationalPatch({{o, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}}})));
  const Point off = {0, 0, power_of_two(-300)};
  CHECK(!have_common_pole(cone(0, 0), RationalPatch({{off, off}, {{0, 0, 1}, {0, 1, 1}}})));
}

}  // namespace exsect::common_pole_test
