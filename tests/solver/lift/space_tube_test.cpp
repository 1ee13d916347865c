// Tubes around chords of circles and of curves that nearly meet.
#include "lift/space_tube.h"

#include <cmath>
#include <tuple>

#include "support/catch.h"

namespace exsect::space_tube_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                      z = SpacePolynomial::variable(2);
SpacePolynomial number(const Rational& c) { return SpacePolynomial::constant(c); }

const SpacePolynomial ball = x * x + y * y + z * z - number(1), plane = z;

/// Of the circle in z = 0, for the tangent of half of its angle.
Point on_circle(const Rational& t) {
  const Rational below = 1 + t * t;
  return {(1 - t * t) / below, 2 * t / below, 0};
}

SpaceZero near(const Point& p) { return {p, 0x1p-40}; }

}  // namespace

TEST_CASE("space tube: a chord of the circle") {
  const Point from = on_circle(Rational(1, 3)), to = on_circle(Rational(2, 5));
  const auto tube = SpaceTube::around(ball, plane, from, to);
  REQUIRE(tube);
  for (const Rational& t : {Rational(1, 3), Rational(7, 20), Rational(3, 8), Rational(2, 5)})
    CHECK(tube->place_of(near(on_circle(t))) == SpaceTube::Place::inside);
  for (const Point& p : {on_circle(Rational(1, 4)), on_circle(Rational(1, 2)), on_circle(-3), Point{0, 0, 0},
                         Rational(9, 8) * from})
    CHECK(tube->place_of(near(p)) == SpaceTube::Place::outside);
  // A cube across its end is neither.
  CHECK(tube->place_of({from, 1}) == SpaceTube::Place::unknown);
  // grad F x grad G = (2 y, -2 x, 0): clockwise.
  CHECK(tube->order(near(from), near(to), 1) == 1);
  CHECK(tube->order(near(to), near(from), 1) == -1);
  CHECK(tube->order(near(to), near(from), -1) == 1);
  CHECK(tube->order(near(from), near(from), 1) == 0);
  const auto turned = SpaceTube::around(plane, ball, from, to);
  REQUIRE(turned);
  CHECK(turned->order(near(from), near(to), 1) == -1);
  // The arc's height over the chord is c^2 / 8 in about.
  const Point chord = to - from;
  const double height = to_double(dot(chord, chord)) / 8, bound = tube->distance_to_chord(from, to);
  CHECK(bound > height);
  CHECK(bound < 4 * height);
}

TEST_CASE("space tube: surfaces that nearly touch, far longer than they are apart") {
  // The second surface is at the angle 2^-40 to the first one; the chord is about tangent to both.
  const Rational small = power_of_two(-40);
  const SpacePolynomial f = y - z + x * x + y * z, g = f + small * (x + z * z);
  for (const auto& [first, second, sense] : {std::tuple(f, g, 1), std::tuple(g, f, -1)}) {
    const Point from = {0, 0, 0}, to = {power_of_two(-40), power_of_two(-12), power_of_two(-12)};
    const auto tube = SpaceTube::around(first, second, from, to);
    REQUIRE(tube);
    // By the gradients in the origin.
    const Point gf = {0, 1, -1}, gg = {small, 1, -1}, along = cross(gf, gg);
    CHECK(tube->order(near(to), near(from), sense) == sign(along[1]));
  }
}

TEST_CASE("space tube: beside a point where two branches touch, of a part of the distance from it") {
  // y = x^2 and y = 3/2 x^2 are t^2 / 2 apart at the distance t, in a plane that is no coordinate plane.
  const SpacePolynomial sheets = (y - z - x * x) * (y - z - Rational(3, 2) * x * x), flat = x + y + 3 * z;
  const auto at = [](const Rational& t) {
    const Rational high = t * t;  // y - z
    return Point{t, (3 * high - t) / 4, (-high - t) / 4};
  };
  for (const int k : {4, 8, 16}) {
    const Rational t = power_of_two(-k);
    const Point from = at(t), to = at(t + t / 32);
    const auto tube = SpaceTube::around(sheets, flat, from, to);
    REQUIRE(tube);
    CHECK(tube->place_of({from, std::ldexp(1.0, -2 * k - 30)}) == SpaceTube::Place::inside);
    CHECK(tube->distance_to_chord(from, to) < std::ldexp(1.0, -2 * k - 4));
  }
}

TEST_CASE("space tube: no proof across a singular point, or of two sheets") {
  CHECK(!SpaceTube::around(x * y, plane, {Rational(-1, 2), 0, 0}, {Rational(1, 2), 0, 0}));
  CHECK(!SpaceTube::around(ball, plane, on_circle(0), on_circle(20)));
  CHECK(!SpaceTube::around(ball, plane, on_circle(0), on_circle(0)));
  // Sheets y = 0 and y = 2^-20 x: a tube beside the crossing, of a part of the distance from it.
  const SpacePolynomial sheets = y * (y - power_of_two(-20) * x);
  CHECK(SpaceTube::around(sheets, plane, {1, 0, 0}, {Rational(9, 8), 0, 0}));
  CHECK(!SpaceTube::around(sheets, plane, {-1, 0, 0}, {Rational(9, 8), 0, 0}));
}

}  // namespace exsect::space_tube_test
