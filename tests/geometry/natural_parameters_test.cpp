#include <exsect/geometry/natural_parameters.h>
#include <exsect/geometry/surface_box.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/catch.h"

namespace exsect::natural_parameters_test {
namespace {

using Box = std::array<RationalInterval, 3>;

Box at(const Point& p) { return {RationalInterval{p[0], p[0]}, {p[1], p[1]}, {p[2], p[2]}}; }
void check(const std::optional<RationalInterval>& found, const Rational& expected) {
  REQUIRE(found);
  CHECK(found->lower <= expected);
  CHECK(found->upper >= expected);
  CHECK(found->width() < power_of_two(-100));
}

const Point origin = {0, 0, 0}, up = {0, 0, 1};

}  // namespace

TEST_CASE("natural parameters: places that are known") {
  const auto cylinder = ImplicitSurface::cylinder({1, 2, 3}, {0, 0, 5}, 2);
  const NaturalParameters east = natural_parameters(cylinder, at({3, 2, 8}));
  check(east.turn, 0);
  check(east.height, 1);
  CHECK_FALSE(east.tube);
  check(natural_parameters(cylinder, at({1, 4, 3})).turn, Rational(1, 4));
  check(natural_parameters(cylinder, at({1, 4, 3})).height, 0);
  // Turned round, it is seen from below: north comes a quarter before east.
  const auto below = ImplicitSurface::cylinder({1, 2, 3}, {0, 0, -5}, 2);
  check(natural_parameters(below, at({1, 4, 8})).turn, Rational(3, 4));
  check(natural_parameters(below, at({1, 4, 8})).height, -1);
  const auto lying = ImplicitSurface::cylinder(origin, {2, 0, 0}, 1);
  check(natural_parameters(lying, at({1, 0, 1})).turn, Rational(1, 4));  // from y to z
  const auto cone = ImplicitSurface::cone(origin, up, 1);
  check(natural_parameters(cone, at({0, -3, 3})).turn, Rational(3, 4));
  CHECK_FALSE(natural_parameters(cone, at(origin)).turn);
  check(natural_parameters(cone, at(origin)).height, 0);
  const auto sphere = ImplicitSurface::sphere({0, 0, 1}, 1);
  check(natural_parameters(sphere, at({-1, 0, 1})).turn, Rational(1, 2));
  CHECK_FALSE(natural_parameters(sphere, at({0, 0, 2})).turn);
  check(natural_parameters(sphere, at({0, 0, 2})).height, 1);
  // About the axis of its box: with the axis along y, turns are counted from x towards -z.
  for (const SurfaceBox& box :
       {SurfaceBox{.axis = Point{0, 3, 0}, .height = HeightRange{-1, Rational(1, 9)}},
        SurfaceBox{.axis = Point{0, 3, 0}, .sector = AxisSector{{1, 5, 0}, {-1, 0, -1}}},
        SurfaceBox{.axis = Point{0, 3, 0},
        .sector = AxisSector{{2, 0, 1}, {-1, 4, -1}},
        .height = HeightRange{-1, 1}}}) {
    const auto lens = boxed(ImplicitSurface::sphere({0, 0, 1}, 5), box);
    check(natural_parameters(lens, at({4, -3, 1})).turn, 0);
    check(natural_parameters(lens, at({4, -3, 1})).height, -1);
    check(natural_parameters(lens, at({0, 3, -3})).turn, Rational(1, 4));
    check(natural_parameters(lens, at({0, 3, -3})).height, 1);
    CHECK_FALSE(natural_parameters(lens, at({0, 5, 1})).turn);
  }
  const auto torus = ImplicitSurface::torus(origin, {0, 0, 7}, 3, 1);
  for (const auto& [p, tube] :
       {std::pair(Point{0, 4, 0}, Rational(0)), std::pair(Point{0, 3, 1}, Rational(1, 4)),
        std::pair(Point{0, 2, 0}, Rational(1, 2)), std::pair(Point{0, 3, -1}, Rational(3, 4))}) {
    check(natural_parameters(torus, at(p)).turn, Rational(1, 4));
    check(natural_parameters(torus, at(p)).tube, tube);
    CHECK_FALSE(natural_parameters(torus, at(p)).height);
  }
  CHECK_FALSE(natural_parameters(ImplicitSurface::plane(origin, up), at(origin)).turn);
}

TEST_CASE("natural parameters: random points of cylinders and tori, and what is made of them again") {
  const unsigned seed = 1848;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> number(-9, 9);
  for (int i = 0; i < 50; ++i) {
    const Point axis = {number(random), number(random), number(random) * 2 + 1};
    const Point centre = {number(random), number(random), number(random)};
    const Point p = {number(random) * 3 + 1, number(random), number(random)};
    const auto torus = ImplicitSurface::torus(centre, axis, 20, 1);
    const NaturalParameters found = natural_parameters(torus, at(p));
    const NaturalParameters along = natural_parameters(ImplicitSurface::cylinder(centre, axis, 1), at(p));
    if (!found.turn) continue;
    REQUIRE(along.turn);
    REQUIRE(along.height);
    CHECK(found.turn->lower == along.turn->lower);
    // In doubles from the definition: e the coordinate axis least along the axis, without its part along it.
    const auto value = [](const Point& q) {
      return std::array{to_double(q[0]), to_double(q[1]), to_double(q[2])};
    };
    const auto a = value(axis), d = value(p - centre);
    std::size_t k = 0;
    for (std::size_t j = 1; j < 3; ++j)
      if (std::fabs(a[j]) < std::fabs(a[k])) k = j;
    const double aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    std::array<double, 3> e{};
    for (std::size_t j = 0; j < 3; ++j) e[j] = (j == k ? 1 : 0) - a[k] * a[j] / aa;
    const std::array n = {a[1] * e[2] - a[2] * e[1], a[2] * e[0] - a[0] * e[2], a[0] * e[1] - a[1] * e[0]};
    const auto inner = [](const auto& b, const auto& c) { return b[0] * c[0] + b[1] * c[1] + b[2] * c[2]; };
    const double x = inner(d, e), y = inner(d, n) / std::sqrt(aa);
    double turn = std::atan2(y, x) / (2 * std::numbers::pi);
    if (turn < 0) turn += 1;
    CHECK(std::fabs(to_double(found.turn->midpoint()) - turn) < 1e-12);
    const double height = inner(d, a) / aa;
    CHECK(std::fabs(to_double(along.height->midpoint()) - height) < 1e-12);
    const double off = std::hypot(x, y) / std::sqrt(inner(e, e)) - 20;
    double tube = std::atan2(height * std::sqrt(aa), off) / (2 * std::numbers::pi);
    if (tube < 0) tube += 1;
    REQUIRE(found.tube);
    CHECK(std::fabs(to_double(found.tube->midpoint()) - tube) < 1e-12);
  }
}

TEST_CASE("natural parameters: a box holds those of all points in it") {
  const auto torus = ImplicitSurface::torus(origin, {1, 2, 2}, 3, 1);
  const Rational e(1, 50);
  const Point middle = {2, -2, Rational(3, 2)};
  Box box;
  for (std::size_t k = 0; k < 3; ++k) box[k] = {middle[k] - e, middle[k] + e};
  const NaturalParameters whole = natural_parameters(torus, box);
  REQUIRE((whole.turn && whole.tube));
  for (int i = 0; i < 27; ++i) {
    const Point p = {middle[0] + (i % 3 - 1) * e, middle[1] + (i / 3 % 3 - 1) * e,
                     middle[2] + (i / 9 - 1) * e};
    const NaturalParameters one = natural_parameters(torus, at(p));
    CHECK((whole.turn->lower <= one.turn->lower && one.turn->upper <= whole.turn->upper));
    CHECK((whole.tube->lower <= one.tube->lower && one.tube->upper <= whole.tube->upper));
  }
  CHECK(whole.turn->width() < Rational(1, 10));
}

}  // namespace exsect::natural_parameters_test
