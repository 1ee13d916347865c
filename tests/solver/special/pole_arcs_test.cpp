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

TEST_CASE("arcs_at_pole: no answer for a double direction, and at an end of the side") {
  CHECK(!arcs(fan(1, 0), plane({1, 2, Rational(3, 2)}, {2, 1, Rational(3, 2)})));  // 2 t (1 - t) = 1/2
  CHECK(!arcs(fan(1, 0), plane({1, 2, 0}, {2, 1, 0})));                            // t = 0, 1
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
