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

TEST_CASE("common_pole: cones that touch along a ruling, and common rulings at the ends") {
  // 2 t (1 - t) has its greatest value, 1/2, at t = 1/2, and is 0 at the ends.
  for (const long bits : {6, 8, 10}) {
    const auto contact = arcs_at_common_pole(cone(1, 0), cone(0, Rational(1, 2)), power_of_two(-bits), kAll);
    if (bits == 6 && !contact) continue;
    REQUIRE(contact);
    REQUIRE(contact->size() == 1);
    CHECK(contact->front().contact == Contact::tangential);
    REQUIRE(contact->front().ray);
    CHECK(contact->front().ray->t == Rational(1, 2));
    const auto ends = arcs_at_common_pole(cone(1, 0), cone(0, 0), power_of_two(-bits), kAll);
    REQUIRE(ends);
    REQUIRE(ends->size() == 2);
    for (const int i : {0, 1}) {
      const PoleArc& arc = (*ends)[static_cast<std::size_t>(i)];
      CHECK(arc.contact == Contact::transversal);
      CHECK(arc.on == std::vector<Side>{{Parameter::v, i}, {Parameter::s, i}});
    }
  }
  // A little less, and there are two rulings; a little more, and there is none.
  const Rational little(1, 1000);
  const auto two = arcs_at_common_pole(cone(1, 0), cone(0, Rational(1, 2) - little), power_of_two(-14), kAll);
  REQUIRE(two);
  CHECK(two->size() == 2);
  for (const PoleArc& arc : *two) CHECK(arc.contact == Contact::transversal);
  const auto none =
      arcs_at_common_pole(cone(1, 0), cone(0, Rational(1, 2) + little), power_of_two(-14), kAll);
  REQUIRE(none);
  CHECK(none->empty());
}

TEST_CASE("common_pole: cups that touch along a parabola, at any speed, and nearly do") {
  // The difference of the heights is (k x - y)^2, or (k x - y)^2 and a little x y.
  for (const Rational& k : {Rational(1), Rational(1, 2), Rational(3)})
    for (const Rational& speed : {Rational(1), Rational(1, 2), Rational(3)})
      for (const bool is_exchanged : {false, true}) {
        CAPTURE(to_double(k), to_double(speed), is_exchanged);
        const auto arcs_with = [&](const Rational& little) {
          const RationalPatch x = cup(1, 0, 1), y = cup(1 + k * k, little - k, 2, speed);
          return is_exchanged ? arcs_at_common_pole(y, x, power_of_two(-10), kAll)
                              : arcs_at_common_pole(x, y, power_of_two(-10), kAll);
        };
        const auto arcs = arcs_with(0);
        REQUIRE(arcs);
        REQUIRE(arcs->size() == 1);
        CHECK(arcs->front().contact == Contact::tangential);
        REQUIRE(arcs->front().ray);
        CHECK(arcs->front().ray->t == k / (1 + k));
        CHECK(arcs->front().ray->on_other[1][0] == k / (1 + k));
        CHECK(arcs->front().ray->on_other[0][1] == (is_exchanged ? speed : Rational(1 / speed)));
        for (const Rational& little : {Rational(1, 1000), Rational(-1, 1000), Rational(1, 1000000)}) {
          const auto near = arcs_with(little);
          if (near)
            for (const PoleArc& arc : *near) CHECK(arc.contact == Contact::transversal);
          if (near) CHECK(near->size() == (little > 0 ? 0 : 2));
        }
      }
}

TEST_CASE("common_pole: a curve along which parameters are constant, with weights") {
  // z = x^2 and z = y^2 over the quadrant, times what a projective map makes of it.
  const auto mapped = [](const RationalPatch& patch, const Rational& p, const Rational& q) {
    std::vector<std::vector<HomogeneousPoint>> net(3, std::vector<HomogeneousPoint>(3));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        HomogeneousPoint& to = net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        to = patch.homogeneous(i, j);
        to[3] += p * to[0] + q * to[1] + to[2] / 3;
      }
    return RationalPatch::from_homogeneous(net);
  };
  const RationalPatch u_again = cup(1, 0, 0).restricted_to(0, Rational(2, 3), 0, 1);
  for (const auto& [p, q] : {std::pair(Rational(0), Rational(0)), {Rational(1, 4), Rational(1, 8)}}) {
    const RationalPatch y = mapped(cup(0, 0, 1), p, q);
    for (const RationalPatch& x : {mapped(cup(1, 0, 0), p, q), mapped(u_again, p, q)}) {
      const auto arcs = arcs_at_common_pole(x, y, power_of_two(-10), kAll);
      REQUIRE(arcs);
      REQUIRE(arcs->size() == 1);
      REQUIRE(arcs->front().ray);
      const PoleRay& ray = *arcs->front().ray;
      CHECK(ray.t == Rational(1, 2));
      for (const Rational& a : {Rational(1, 7), Rational(1, 1024)}) {
        const auto on_other = [&](std::size_t j) {
          return Rational((ray.on_other[j][0] + ray.on_other[j][1] * a) / (1 + ray.bend * a));
        };
        CHECK(x(a, ray.t) == y(on_other(0), on_other(1)));
      }
      CHECK(arcs->front().contact == Contact::transversal);
    }
  }
}

TEST_CASE("common_pole: arcs in the direction of ends, inside, outside and along the side") {
  // b (1 - s, s, 0) + b^2 (0, lean (1 - s)^2, 0), where y = 0 if s = -lean b (1 - s)^2.
  const Point o = {0, 0, 0};
  const Rational half(1, 2), quarter(1, 4);
  const auto bent = [&](const Rational& lean) {
    return RationalPatch({{o, o, o},
                          {{half, 0, 0}, {quarter, quarter, 0}, {0, half, 0}},
                          {{1, lean, 0}, {half, half, 0}, {0, 1, 0}}});
  };
  // The plane y = 0 in directions (1,0,-1) to (1,0,1), and (1,0,0) to (1,0,1).
  const RationalPatch wall({{o, o}, {{1, 0, -1}, {1, 0, 1}}}), half_wall({{o, o}, {{1, 0, 0}, {1, 0, 1}}});
  const std::vector<Parameter> all_but_of_wall = {Parameter::u, Parameter::v, Parameter::r};
  for (const int lean : {-1, 0, 1})
    for (const bool is_reversed : {false, true}) {
      CAPTURE(lean, is_reversed);
      const RationalPatch x = is_reversed ? bent(lean).restricted_to(0, 1, 1, 0) : bent(lean);
      const auto arcs = arcs_at_common_pole(x, wall, power_of_two(-8), all_but_of_wall);
      REQUIRE(arcs);
      CHECK(arcs->size() == (lean > 0 ? 0 : 1));
      const auto exchanged = arcs_at_common_pole(wall, x, power_of_two(-8), {});
      REQUIRE(exchanged);
      CHECK(exchanged->size() == arcs->size());
      const auto at_both = arcs_at_common_pole(x, half_wall, power_of_two(-8), all_but_of_wall);
      CHECK(at_both.has_value() == (lean >= 0));  // z = 0 along the curve: it stays on the side of the wall
      if (lean > 0) CHECK(at_both->empty());
      if (lean < 0) CHECK(arcs->front().on.empty());
      if (lean != 0) continue;
      CHECK(arcs->front().on == std::vector<Side>{{Parameter::v, is_reversed ? 1 : 0}});
      REQUIRE(at_both->size() == 1);
      CHECK(at_both->front().on == std::vector<Side>{{Parameter::v, is_reversed ? 1 : 0}, {Parameter::s, 0}});
    }
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
