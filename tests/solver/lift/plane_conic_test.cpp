// Lines and conics of space above a plane: kinds, centres, the planes they are in.
#include "lift/plane_conic.h"

#include <random>

#include "support/catch.h"

namespace exsect::plane_conic_test {
namespace {

BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }
const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();

/// u and v along the first two axes, y along the third one.
SurfaceChart plain() { return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}; }

}  // namespace

TEST_CASE("plane conic: kinds, and the centre as the zero of both derivatives") {
  CHECK(PlaneConic(r * r + number(2) * s * s - number(1)).kind() == SpaceCurveKind::ellipse);
  CHECK(PlaneConic(r * s - number(1)).kind() == SpaceCurveKind::hyperbola);
  CHECK(PlaneConic(r * r - s).kind() == SpaceCurveKind::parabola);
  CHECK(PlaneConic(r * r - s * s).is_degenerate());
  CHECK_FALSE(PlaneConic(r * r - s * s - number(1)).is_degenerate());
  const std::uint64_t seed = 20261127;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  const auto small = [&] { return Rational(static_cast<long>(random() % 19) - 9, 1 + random() % 3); };
  for (int i = 0; i < 50; ++i) {
    const BivariatePolynomial g = number(small()) * r * r + number(small()) * r * s +
                                  number(small()) * s * s + number(small()) * r + number(small()) * s +
                                  number(small());
    const PlaneConic conic(g);
    if (conic.discriminant() == 0) continue;
    const auto [u, v] = conic.centre();
    CHECK(2 * conic.a * u + conic.b * v + conic.d == 0);
    CHECK(conic.b * u + 2 * conic.c * v + conic.e == 0);
    CHECK(conic.is_degenerate() == (g(u, v) == 0));
  }
}

TEST_CASE("plane conic: conjugate lines multiply out") {
  for (const BivariatePolynomial& g :
       {r * r - number(2) * s * s, s * s - number(3),
        (r + s) * (r + s) - number(5) * (r - number(1)) * (r - number(1)),
        number(3) * r * r + number(6) * r * s + number(3) * s * s - number(6)}) {
    const auto [x, z, delta] = conjugate_lines(g);
    // A multiple of g is x^2 - delta z^2, or x^2 less a number.
    const BivariatePolynomial rest = x * x - number(delta) * z * z;
    const Rational scale = rest.coefficient(2, 0) != 0
                               ? Rational(rest.coefficient(2, 0) / g.coefficient(2, 0))
                               : Rational(rest.coefficient(0, 2) / g.coefficient(0, 2));
    const BivariatePolynomial left = rest - number(scale) * g;
    CHECK((delta == 0 ? left.total_degree() < 1 : left.is_zero()));
  }
}

TEST_CASE("plane conic: circles of a tilted plane, and their planes") {
  // The plane y = 3/4 u: u has the length 5/4 there, so 25 u^2/16 + v^2 = 4 is a circle of radius 2.
  const BivariatePolynomial g = number(Rational(25, 16)) * r * r + s * s - number(4);
  const auto plane = plane_through({number(Rational(-3, 4)) * r, number(1)}, g);
  REQUIRE(plane);
  CHECK(*plane == PlaneAbove{Rational(3, 4), 0, 0});
  const SpaceCurve circle = conic_in_plane(plain(), PlaneConic(g), *plane);
  CHECK(circle.kind == SpaceCurveKind::circle);
  REQUIRE(circle.radius_squared);
  CHECK(*circle.radius_squared == 4);
  REQUIRE(circle.direction);
  CHECK(is_zero(cross(*circle.direction, Point{-3, 0, 4})));
  // The same conic in the plane of u and v is an ellipse; nothing is in a plane with y = u^2 - v^2.
  CHECK(conic_in_plane(plain(), PlaneConic(g), {0, 0, 0}).kind == SpaceCurveKind::ellipse);
  CHECK_FALSE(plane_through({s * s - r * r, number(1)}, g));
  // y = u^2 + v^2 is constant on the circle u^2 + v^2 = 1.
  const auto flat = plane_through({number(-1) * (r * r + s * s), number(1)}, r * r + s * s - number(1));
  REQUIRE(flat);
  CHECK(*flat == PlaneAbove{0, 0, 1});
}

TEST_CASE("plane conic: mirrored conics, and lines") {
  // y = +- (3 u) / 4, as line / sqrt(square) with line = 3 u and square = 16.
  const BivariatePolynomial g = number(Rational(25, 16)) * r * r + s * s - number(4);
  const SpaceCurve mirrored = mirrored_conic(plain(), PlaneConic(g), number(3) * r, 16);
  CHECK(mirrored.kind == SpaceCurveKind::circle);
  REQUIRE(mirrored.radius_squared);
  CHECK(*mirrored.radius_squared == 4);
  CHECK_FALSE(mirrored.direction);
  // u = 2 v + 1 in y = u + v + 1.
  const SpaceCurve line = line_in_plane(plain(), r - number(2) * s - number(1), {1, 1, 1});
  REQUIRE((line.direction && line.point));
  CHECK(is_zero(cross(*line.direction, Point{2, 1, 3})));
  CHECK((*line.point)[0] == 2 * (*line.point)[1] + 1);
  CHECK((*line.point)[2] == (*line.point)[0] + (*line.point)[1] + 1);
}

TEST_CASE("plane conic: remainders tell what vanishes on a curve") {
  const BivariatePolynomial g = r * r + s * s - number(1);
  CHECK(vanishes_on(g * (r - number(7)), g));
  CHECK_FALSE(vanishes_on(g * (r - number(7)) + s, g));
}

}  // namespace exsect::plane_conic_test
