#include <exsect/geometry/implicit_surface.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::implicit_surface_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0);
const SpacePolynomial y = SpacePolynomial::variable(1);
const SpacePolynomial z = SpacePolynomial::variable(2);
SpacePolynomial number(const Rational& q) { return SpacePolynomial::constant(q); }

/// Where a maker sees an error; "" if it does not.
template <class Maker>
std::string refused_at(const Maker& maker) {
  try {
    maker();
    return "";
  } catch (const SurfaceError& error) {
    CHECK(std::string(error.what()) == error.where() + ": " + error.reason());
    return error.where();
  }
}

TEST_CASE("data that are no surface are refused with the key at fault") {
  const Point o = {0, 0, 0}, d = {1, 1, 1};
  CHECK(refused_at([&] { ImplicitSurface::plane(o, o); }) == "normal");
  CHECK(refused_at([&] { ImplicitSurface::cylinder(o, o, 1); }) == "axis");
  CHECK(refused_at([&] { ImplicitSurface::cylinder(o, d, 0); }) == "radius");
  CHECK(refused_at([&] { ImplicitSurface::cylinder(o, d, Rational(-1, 1000)); }) == "radius");
  CHECK(refused_at([&] { ImplicitSurface::sphere(o, Length::of_squared(-2)); }) == "radius");
  CHECK(refused_at([&] { ImplicitSurface::sphere(o, 0); }) == "radius");
  CHECK(refused_at([&] { ImplicitSurface::cone(o, o, 1); }) == "axis");
  CHECK(refused_at([&] { ImplicitSurface::cone(o, d, 0); }) == "slope");
  CHECK(refused_at([&] { ImplicitSurface::cone(o, d, 1, 0); }) == "nappes");
  CHECK(refused_at([&] { ImplicitSurface::cone(o, d, 1, 3); }) == "nappes");
  CHECK(refused_at([&] { ImplicitSurface::torus(o, o, 2, 1); }) == "axis");
  CHECK(refused_at([&] { ImplicitSurface::torus(o, d, 0, 1); }) == "major");
  CHECK(refused_at([&] { ImplicitSurface::torus(o, d, -2, 1); }) == "major");
  CHECK(refused_at([&] { ImplicitSurface::torus(o, d, 2, 0); }) == "minor");
  CHECK(refused_at([&] { ImplicitSurface::torus(o, d, 2, Length::of_squared(4)); }) == "minor");
  CHECK(refused_at([&] { ImplicitSurface::torus(o, d, 2, 3); }) == "minor");
  CHECK(refused_at([&] { ImplicitSurface::torus(o, d, 2, 2 - power_of_two(-200)); }).empty());
  CHECK(refused_at([&] { ImplicitSurface::polynomial({}); }) == "terms");
  CHECK(refused_at([&] { ImplicitSurface::polynomial(number(3)); }) == "terms");
  CHECK(refused_at([&] { ImplicitSurface::polynomial(x * x * y * y * z); }) == "terms");
  CHECK(refused_at([&] { ImplicitSurface::polynomial(x * x * y * y + z); }).empty());
}

TEST_CASE("equations about the axes of coordinates are the known ones") {
  const Point o = {0, 0, 0}, up = {0, 0, 1};
  CHECK(ImplicitSurface::plane({0, 0, 5}, {0, 0, 2}).equation() == Rational(2) * z - number(10));
  CHECK(ImplicitSurface::cylinder(o, up, 3).equation() == x * x + y * y - number(9));
  CHECK(ImplicitSurface::cylinder(o, up, Length::of_squared(2)).equation() == x * x + y * y - number(2));
  CHECK(ImplicitSurface::cone(o, up, Rational(1, 2)).equation() == x * x + y * y - Rational(1, 4) * z * z);
  CHECK(ImplicitSurface::sphere({1, 0, 0}, 2).equation() ==
        x * x + y * y + z * z - Rational(2) * x - number(3));
  const SpacePolynomial s = x * x + y * y + z * z + number(8);
  CHECK(ImplicitSurface::torus(o, up, 3, 1).equation() == s * s - Rational(36) * (x * x + y * y));
  CHECK(std::string(name(ImplicitSurface::torus(o, up, 3, 1).kind())) == "torus");
  CHECK(std::string(name(ImplicitSurface::polynomial(x).kind())) == "implicit");
}

TEST_CASE("a cone has one nappe unless two are asked for") {
  const ImplicitSurface one = ImplicitSurface::cone({0, 0, 1}, {0, 0, -2}, 1);
  const ImplicitSurface two = ImplicitSurface::cone({0, 0, 1}, {0, 0, -2}, 1, 2);
  CHECK(one.equation() == two.equation());
  CHECK(one.contains({0, 0, 1}));
  CHECK(one.contains({1, 0, 0}));
  CHECK_FALSE(one.contains({1, 0, 2}));
  CHECK(two.contains({1, 0, 2}));
  CHECK_FALSE(two.contains({1, 0, 3}));
  CHECK_FALSE(two.bound().has_value());
}

Point axis_point(const Point& c, const Point& d, const Rational& t) { return c + t * d; }

TEST_CASE("equations agree with the formulas for distances, for axes without rational length") {
  const std::uint64_t seed = 26001;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 20; ++round) {
    const Point c = random_point(random), p = random_point(random);
    const Point d = round == 0 ? Point{1, 1, 1} : random_point(random);
    if (is_zero(d)) continue;
    const Rational radius = 1 + abs(random_rational(random)), major = radius + 1;
    const Point q = p - c, moment = cross(q, d);
    const Rational dd = dot(d, d), a = dot(moment, moment) / dd, h = dot(q, d) * dot(q, d) / dd;
    CHECK(ImplicitSurface::cylinder(c, d, radius).equation()(p) == dd * (a - radius * radius));
    CHECK(ImplicitSurface::cone(c, d, radius).equation()(p) == dd * (a - radius * radius * h));
    CHECK(ImplicitSurface::sphere(c, radius).equation()(p) == a + h - radius * radius);
    // ((r - R)^2 + k) ((r + R)^2 + k) with r^2 = a, k = h - radius^2
    const Rational k = h - radius * radius, m = major * major;
    CHECK(ImplicitSurface::torus(c, d, major, radius).equation()(p) ==
          dd * ((a - m) * (a - m) + 2 * k * (a + m) + k * k));
    CHECK(ImplicitSurface::plane(c, d).equation()(p) == dot(q, d));
    CHECK(ImplicitSurface::plane(c, d).contains(axis_point(c, cross(d, p), 7)));
    CHECK(ImplicitSurface::cone(c, d, radius).contains(c));
  }
}

/// A rational point of the unit circle.
struct CirclePoint {
  Rational c;
  Rational s;
  explicit CirclePoint(const Rational& t) : c((1 - t * t) / (1 + t * t)), s(2 * t / (1 + t * t)) {}
};

TEST_CASE("rational points of round surfaces in a turned frame lie on them, their neighbours do not") {
  const std::uint64_t seed = 26002;
  INFO("seed " << seed);
  Random random(seed);
  const Rational third(1, 3), inch(254, 10);
  const Point e1 = third * Point{2, 1, -2}, e2 = third * Point{2, -2, 1}, e3 = third * Point{1, 2, 2};
  for (int round = 0; round < 20; ++round) {
    // The centre is one of doubles at 1e8, lengths are doubles scaled to millimetres.
    const Point c = {from_double(1e8 + 0.1), from_double(-1e8 / 3), from_double(0.7)};
    const Rational minor = inch * from_double(0.1 * (round + 1)), major = minor + from_double(1e-3);
    const Point d = (1 + abs(random_rational(random))) * e3;
    const CirclePoint turn(random_rational(random)), profile(random_rational(random));
    const Rational height = random_rational(random);
    const Point out = turn.c * e1 + turn.s * e2;
    const auto check = [&](const ImplicitSurface& surface, const Point& p) {
      CHECK(surface.contains(p));
      CHECK_FALSE(surface.contains(p + power_of_two(-70) * e1 + power_of_two(-71) * e2));
    };
    check(ImplicitSurface::cylinder(c, d, minor), c + minor * out + height * e3);
    check(ImplicitSurface::sphere(c, minor), c + minor * (profile.c * out + profile.s * e3));
    check(ImplicitSurface::torus(c, d, major, minor),
          c + (major + minor * profile.c) * out + (minor * profile.s) * e3);
    check(ImplicitSurface::cone(c, d, minor, 2), c + height * (minor * out + e3));
    CHECK(ImplicitSurface::cone(c, d, minor).contains(c + height * (minor * out + e3)) == (height >= 0));
  }
}

}  // namespace
}  // namespace exsect::implicit_surface_test
