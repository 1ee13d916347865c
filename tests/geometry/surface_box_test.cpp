#include <exsect/geometry/surface_box.h>

#include <cmath>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::surface_box_test {
namespace {

const Point origin = {0, 0, 0}, up = {0, 0, 1};

SurfaceBox sector(const Point& from, const Point& to) { return {.sector = AxisSector{from, to}}; }
SurfaceBox height(const Rational& from, const Rational& to) { return {.height = HeightRange{from, to}}; }

/// The rational point of the unit circle at the angle 2 atan(t).
std::array<Rational, 2> on_circle(const Rational& t) {
  const Rational n = 1 + t * t;
  return {(1 - t * t) / n, 2 * t / n};
}

/// In [0, 2 pi).
double angle(double x, double y) {
  const double a = std::atan2(y, x);
  return a < 0 ? a + 2 * M_PI : a;
}
double turn(double from, double to) { return to < from ? to - from + 2 * M_PI : to - from; }

TEST_CASE("sectors of less than, exactly and more than half a turn hold their closed ends") {
  const ImplicitSurface pipe = ImplicitSurface::cylinder(origin, up, 1);
  const Point east = {1, 0, 9}, north = {0, 1, 9}, west = {-1, 0, 9}, south = {0, -1, 9};
  const ImplicitSurface quarter = boxed(pipe, sector(east, north)), half = boxed(pipe, sector(east, west)),
                        most = boxed(pipe, sector(east, south)), other = boxed(pipe, sector(north, east));
  for (const Point& p : {east, north}) {
    CHECK((quarter.contains(p) && half.contains(p) && most.contains(p) && other.contains(p)));
  }
  CHECK((!quarter.contains(west) && half.contains(west) && most.contains(west) && other.contains(west)));
  CHECK((!quarter.contains(south) && !half.contains(south) && most.contains(south) && other.contains(south)));
  const Point between = {Rational(3, 5), Rational(-4, 5), 0}, inside = {Rational(3, 5), Rational(4, 5), 0};
  CHECK((!half.contains(between) && !most.contains(between) && other.contains(between)));
  CHECK((quarter.contains(inside) && !other.contains(inside)));
}

TEST_CASE("sectors about the axis z agree with angles") {
  const std::uint64_t seed = 28001;
  INFO("seed " << seed);
  Random random(seed);
  const ImplicitSurface pipe = ImplicitSurface::cylinder(origin, up, 1);
  for (int round = 0; round < 300; ++round) {
    const Point from = random_point(random), to = random_point(random);
    const double a = angle(to_double(from[0]), to_double(from[1]));
    const double b = angle(to_double(to[0]), to_double(to[1]));
    if (std::fabs(turn(a, b)) < 1e-6 || turn(a, b) > 2 * M_PI - 1e-6) continue;
    if ((from[0] == 0 && from[1] == 0) || (to[0] == 0 && to[1] == 0)) continue;
    const auto [x, y] = on_circle(random_rational(random));
    const double c = angle(to_double(x), to_double(y));
    if (std::fabs(turn(a, c) - turn(a, b)) < 1e-9 || turn(a, c) < 1e-9) continue;
    const ImplicitSurface face = boxed(pipe, sector(from, to));
    CHECK(face.contains({x, y, random_rational(random)}) == (turn(a, c) < turn(a, b)));
    CHECK(boxed(pipe, sector(to, from)).contains({x, y, 0}) != (turn(a, c) < turn(a, b)));
  }
}

TEST_CASE("sectors of the tube agree with angles, for axes of any length") {
  const std::uint64_t seed = 28002;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 300; ++round) {
    const Rational major = 5, minor = 2, length = abs(random_rational(random)) + Rational(1, 7);
    const ImplicitSurface ring = ImplicitSurface::torus(origin, length * up, major, minor);
    const auto [x, y] = on_circle(random_rational(random));
    const auto [c, s] = on_circle(random_rational(random));
    const Rational distance = major + minor * c;
    const Point p = {distance * x, distance * y, minor * s};
    REQUIRE(ring.contains(p));
    TubeSector tube = {{random_rational(random), random_rational(random)},
                       {random_rational(random), random_rational(random)}};
    const auto of = [&](const std::array<Rational, 2>& d) {
      return angle(to_double(d[0] * major), to_double(d[1] * length));
    };
    const double a = of(tube.from), b = of(tube.to), at = angle(to_double(c), to_double(s));
    if (turn(a, b) < 1e-6 || turn(a, b) > 2 * M_PI - 1e-6) continue;
    if (std::fabs(turn(a, at) - turn(a, b)) < 1e-9 || turn(a, at) < 1e-9) continue;
    CHECK(boxed(ring, {.tube = tube}).contains(p) == (turn(a, at) < turn(a, b)));
  }
}

TEST_CASE("heights and sides count in multiples of their vectors") {
  const Point axis = {1, 1, 1};
  const ImplicitSurface pipe = ImplicitSurface::cylinder({1, 0, 0}, axis, Length::of_squared(2));
  const ImplicitSurface face = boxed(pipe, height(Rational(-1, 2), 2));
  const Point foot = {2, -1, 0};  // at height 0
  REQUIRE(pipe.contains(foot));
  CHECK(face.contains(foot + Rational(2) * axis));
  CHECK_FALSE(face.contains(foot + Rational(201, 100) * axis));
  CHECK(face.contains(foot - Rational(1, 2) * axis));
  CHECK_FALSE(face.contains(foot - Rational(51, 100) * axis));
  const Point corner = {1, 2, 3}, normal = {1, -1, 0}, first = {1, 1, 0}, second = {2, 2, -3};
  const ImplicitSurface sheet =
      boxed(ImplicitSurface::plane(corner, normal), {.sides = std::array<Point, 2>{first, second}});
  for (int i = -2; i <= 6; ++i)
    for (int j = -2; j <= 6; ++j)
      CHECK(sheet.contains(corner + Rational(i, 4) * first + Rational(j, 4) * second) ==
            (i >= 0 && i <= 4 && j >= 0 && j <= 4));
  CHECK_THROWS_AS(boxed(face, height(0, 1)), std::invalid_argument);
}

TEST_CASE("a face seen from elsewhere, and turned and scaled, is the same face") {
  const std::uint64_t seed = 28003;
  INFO("seed " << seed);
  Random random(seed);
  const Rational third(1, 3), inch(254, 10);
  const Point far = {from_double(1e8 + 0.1), from_double(-1e8 / 3), from_double(0.7)};
  const auto turned = [&](const Point& p) {
    return third * (p[0] * Point{2, 1, -2} + p[1] * Point{2, -2, 1} + p[2] * Point{-1, -2, -2});
  };
  const auto moved = [&](const Point& p) { return far + inch * turned(p); };
  REQUIRE(determinant(turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})) == 1);
  for (int round = 0; round < 60; ++round) {
    const Point from = random_point(random), to = random_point(random);
    if (cross(from, up) == origin || cross(to, up) == origin || cross(from, to)[2] == 0) continue;
    const TubeSector tube = {{1, random_rational(random)}, {-1, random_rational(random)}};
    const SurfaceBox box = {.sector = AxisSector{from, to}, .tube = tube};
    const SurfaceBox other = {.sector = AxisSector{turned(from), turned(to)}, .tube = tube};
    const ImplicitSurface here = boxed(ImplicitSurface::torus(origin, Rational(5) * up, 5, 2), box);
    const ImplicitSurface there = boxed(
        ImplicitSurface::torus(moved(origin), inch * turned(Rational(5) * up), 5 * inch, 2 * inch), other);
    const ImplicitSurface back = there.seen_from(far, Rational(1, 1024));
    for (int i = 0; i < 10; ++i) {
      const auto [x, y] = on_circle(random_rational(random));
      const auto [c, s] = on_circle(random_rational(random));
      const Point p = {(5 + 2 * c) * x, (5 + 2 * c) * y, 2 * s};
      CHECK(there.contains(moved(p)) == here.contains(p));
      CHECK(back.contains(Rational(1024) * (moved(p) - far)) == here.contains(p));
    }
  }
}

}  // namespace
}  // namespace exsect::surface_box_test
