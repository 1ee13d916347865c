// Arcs that begin in a pole: cones against the lines in which planes meet them, and where they are refused.
#include "special/pole_arcs.h"

#include <cmath>

#include "support/catch.h"

namespace exsect::pole_arcs_test {
namespace {

/// x(a,t) = a (1 - t, t, bend a) + 2 a t (1 - t) (0,0,wave): a cone if bend = 0.
RationalPatch fan(const Rational& wave, const Rational& bend) {
  const Rational h(1, 2);
  std::vector<std::vector<Point>> net;
  for (long i = 0; i < 3; ++i) {
    net.emplace_back();
    for (long j = 0; j < 3; ++j)
      net.back().push_back({i * (2 - j) * h * h, i * j * h * h,
                            (j == 1 ? i * h * wave : Rational(0)) + (i == 2 ? bend : Rational(0))});
  }
  return RationalPatch(net);
}

/// A square about the origin, in the plane of two vectors.
RationalPatch plane(const Point& p, const Point& q) {
  const auto at = [&](long i, long j) -> Point { return Rational(2 * i - 1) * p + Rational(2 * j - 1) * q; };
  return RationalPatch({{at(0, 0), at(0, 1)}, {at(1, 0), at(1, 1)}});
}

std::optional<std::vector<PoleArc>> arcs(const RationalPatch& x, const RationalPatch& y,
                                         const std::vector<Parameter>& turning = {
                                             Parameter::u, Parameter::v, Parameter::r, Parameter::s}) {
  const auto pole = pole_on_patch(x, y);
  REQUIRE(pole);
  return arcs_at_pole(x, y, *pole, Rational(1, 256), turning);
}

}  // namespace

TEST_CASE("arcs_at_pole: one for each direction of a cone in a plane") {
  // The cone's direction at t is (1 - t, t, 2 t (1 - t)); z = c (x + y) holds where 2 t (1 - t) = c.
  for (const auto& [c, count] :
       {std::pair(Rational(1, 3), std::size_t{2}), std::pair(Rational(2, 3), std::size_t{0})}) {
    const auto found = arcs(fan(1, 0), plane({1, 2, 3 * c}, {2, 1, 3 * c}));
    REQUIRE(found);
    REQUIRE(found->size() == count);
    for (std::size_t i = 0; i < count; ++i) {
      const double root = 0.5 + (i == 0 ? -0.5 : 0.5) * std::sqrt(1 - 2 * to_double(c));
      const PoleArc& arc = (*found)[i];
      CHECK(to_double(arc.along.lower) < root);
      CHECK(root < to_double(arc.along.upper));
      CHECK(to_double(arc.along.width()) < 0.01);
      CHECK(std::abs(arc.step[0] - (1 - root) / 256) <= arc.bend);
      CHECK(std::abs(arc.step[2] - to_double(c) / 256) <= arc.bend);
    }
  }
}

TEST_CASE("arcs_at_pole: a plane that holds all directions is touched, or not decided") {
  const RationalPatch floor = plane({1, 0, 0}, {0, 1, 0});
  const auto above = arcs(fan(0, 1), floor);
  REQUIRE(above);
  CHECK(above->empty());
  CHECK(!arcs(fan(0, 0), floor));  // in the plane
}

TEST_CASE("arcs_at_pole: no answer for a double direction of a patch that is no cone") {
  CHECK(!arcs(fan(1, 1), plane({1, 2, Rational(3, 2)}, {2, 1, Rational(3, 2)})));  // 2 t (1 - t) = 1/2
}

TEST_CASE("arcs_at_pole: a plane touches a cone along a ruling") {
  const auto found = arcs(fan(1, 0), plane({1, 2, Rational(3, 2)}, {2, 1, Rational(3, 2)}));  // t = 1/2
  REQUIRE(found);
  REQUIRE(found->size() == 1);
  CHECK(found->front().contact == Contact::tangential);
  CHECK(found->front().on.empty());
  CHECK(std::abs(to_double(found->front().along.midpoint()) - 0.5) < 0.01);
}

TEST_CASE("arcs_at_pole: sides of a cone in a plane, and touched by it") {
  const auto ends = arcs(fan(1, 0), plane({1, 2, 0}, {2, 1, 0}));
  REQUIRE(ends);
  REQUIRE(ends->size() == 2);
  for (int end = 0; end < 2; ++end) {
    const PoleArc& arc = (*ends)[static_cast<std::size_t>(end)];
    CHECK(arc.on == std::vector<Side>{{Parameter::v, end}});
    CHECK(arc.contact == Contact::transversal);
  }
  // z = 2 y touches at t = 0, z = 2 x at t = 1.
  for (int end = 0; end < 2; ++end) {
    const auto found = arcs(fan(1, 0), end == 0 ? plane({1, 0, 0}, {0, 1, 2}) : plane({0, 1, 0}, {1, 0, 2}));
    REQUIRE(found);
    REQUIRE(found->size() == 1);
    CHECK(found->front().on == std::vector<Side>{{Parameter::v, end}});
    CHECK(found->front().contact == Contact::tangential);
  }
}

TEST_CASE("arcs_at_pole: in the direction of an end of the side, inwards, outwards and along it") {
  // x(a,t) = a ((1 - t), t + bend a (1 - t), 0) leaves y = 0 at t = 0: t = -bend a / (1 - bend a).
  for (const int bend : {-1, 0, 1}) {
    const Rational h(1, 2);
    const RationalPatch x({{{0, 0, 0}, {0, 0, 0}}, {{h, 0, 0}, {0, h, 0}}, {{1, bend, 0}, {0, 1, 0}}});
    const auto reversed = [](const RationalPatch& of) { return of.restricted_to(0, 1, 1, 0); };
    for (const bool at_one : {false, true}) {
      INFO("bend " << bend << ", at 1 " << at_one);
      const auto found = arcs(at_one ? reversed(x) : x, plane({1, 0, 1}, {1, 0, -1}));
      REQUIRE(found);
      REQUIRE(found->size() == (bend > 0 ? std::size_t{0} : std::size_t{1}));
      if (bend > 0) continue;
      const auto side = std::vector<Side>{{Parameter::v, at_one ? 1 : 0}};
      CHECK(found->front().on == (bend == 0 ? side : std::vector<Side>{}));
    }
  }
}

TEST_CASE("arcs_at_pole: the weight is not positive beyond an end of the side") {
  // w = 1 - t + 1/64 in t vanishes at 65/64: cells beyond t = 1 are left out, and t = 0 is decided.
  const std::vector<std::vector<Rational>> weights = {{Rational(65, 64), Rational(1, 64)},
                                                      {Rational(65, 64), Rational(1, 64)}};
  const RationalPatch x({{{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {0, 1, 0}}}, weights);
  const auto at_zero = arcs(x, plane({1, 0, 0}, {0, 0, 1}));
  REQUIRE(at_zero);
  CHECK(at_zero->size() == 1);
  CHECK(!arcs(x, plane({0, 1, 0}, {0, 0, 1})));
}

TEST_CASE("arcs_at_pole: sides of the other patch that are rulings") {
  // The ruling t = 1/3 is the side s = 0, or is beside it.
  const Point ruling = {2, 1, Rational(4, 3)}, across = {1, 0, 1};
  const auto sheet = [&](const Rational& from) {
    const auto at = [&](long i, const Rational& j) -> Point { return Rational(i) * ruling + j * across; };
    return RationalPatch({{at(-1, from), at(-1, 1)}, {at(1, from), at(1, 1)}});
  };
  const auto on_side = arcs(fan(1, 0), sheet(0));
  REQUIRE(on_side);
  REQUIRE(on_side->size() == 1);
  CHECK(on_side->front().on == std::vector<Side>{{Parameter::s, 0}});
  const auto beside = arcs(fan(1, 0), sheet(Rational(-1, 2)));
  REQUIRE(beside);
  REQUIRE(beside->size() == 1);
  CHECK(beside->front().on.empty());
}

TEST_CASE("arcs_at_pole: a plane that touches all directions, with arcs") {
  // x = a (1 - t, t, a (1 - 3 t)) leaves z = 0 at t = 1/3; with 1 - 3 t for 3 t it is along a side.
  const Rational h(1, 2);
  const auto saddle = [&](const Rational& p, const Rational& q) {
    return RationalPatch({{{0, 0, 0}, {0, 0, 0}}, {{h, 0, 0}, {0, h, 0}}, {{1, 0, p}, {0, 1, q}}});
  };
  const RationalPatch floor = plane({1, 0, 0}, {0, 1, 0});
  const auto crossing = arcs(saddle(1, -2), floor), side = arcs(saddle(0, 1), floor);
  REQUIRE(crossing);
  REQUIRE(crossing->size() == 1);
  CHECK(crossing->front().contact == Contact::transversal);
  CHECK(std::abs(to_double(crossing->front().along.midpoint()) - 1.0 / 3) < 0.01);
  REQUIRE(side);
  REQUIRE(side->size() == 1);
  CHECK(side->front().on == std::vector<Side>{{Parameter::v, 0}});
}

TEST_CASE("arcs_at_pole: a parameter that begins still is monotone") {
  // 4 (2 r - 1) = a^2 along the arc.
  const auto found = arcs(fan(0, 1), plane({1, 1, 4}, {1, 2, 0}), {Parameter::r});
  REQUIRE(found);
  CHECK(found->size() == 1);
}

TEST_CASE("arcs_at_pole: parameters are constant along rulings that are parameter lines of the plane") {
  // The arc is the ruling t = 1/3 of the cone, in the direction of s.
  const Point ruling = {2, 1, Rational(4, 3)}, across = {1, 0, 1};
  for (const RationalPatch& sheet : {plane(across, ruling), plane(ruling, across)}) {
    const auto found = arcs(fan(1, 0), sheet);
    REQUIRE(found);
    CHECK(found->size() == 1);
  }
  // (2 r - 1 + w^3) across + w ruling, w = 2 s - 1: r is not constant, but turns to third order.
  std::vector<std::vector<Point>> net(2);
  for (const long i : {0, 1})
    for (const long k : {0, 1, 2, 3})
      net[static_cast<std::size_t>(i)].push_back(Rational(2 * i - 1 + (k % 2 == 0 ? -1 : 1)) * across +
                                                 Rational(2 * k - 3, 3) * ruling);
  CHECK(!arcs(fan(1, 0), RationalPatch(net), {Parameter::r}));
  CHECK(arcs(fan(1, 0), RationalPatch(net), {Parameter::s}));
}

}  // namespace exsect::pole_arcs_test
