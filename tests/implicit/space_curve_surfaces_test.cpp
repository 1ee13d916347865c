#include <exsect/geometry/implicit_curve.h>
#include <exsect/implicit/implicitize_space_curve.h>

#include <cmath>

#include "geometry/curve_specimens.h"
#include "support/catch.h"

namespace exsect::space_curve_surfaces_test {

namespace {

SpaceOptions options_of(SpaceMethod method, const Rational& epsilon = 1000, int factor_degree = 2) {
  SpaceOptions options;
  options.method = method;
  options.epsilon = epsilon;
  options.factor_degree = factor_degree;
  const RationalInterval side = {Rational(0), Rational(6, 5)};
  options.box = SpaceBox{side, side, side};
  return options;
}

bool vanishes(const SpacePolynomial& f, const BezierCurve& curve) {
  return composed(f, homogeneous(curve)).is_zero();
}

}  // namespace

TEST_CASE("the axis is one whose coordinate is monotone", "[space_curve_surfaces]") {
  CHECK(choose_axis(space_cubic()).axis == 0);
  CHECK(choose_axis(space_cubic()).is_regular);
  CHECK(is_strictly_monotone(space_cubic(), 0));
  CHECK_FALSE(is_strictly_monotone(space_cubic(), 1));
  // x is constant, y goes back and forth, z grows.
  const BezierCurve upwards({{1, 0, 0}, {1, 1, 1}, {1, 0, 2}});
  CHECK(choose_axis(upwards).axis == 2);
  CHECK(choose_axis(upwards).is_regular);
  // Every coordinate turns.
  const BezierCurve turning({{0, 0, 0}, {1, 2, 0}, {2, 1, 3}, {0, 0, 1}});
  CHECK_FALSE(choose_axis(turning).is_regular);
  CHECK_THROWS_AS(choose_axis(profile_cubic()), std::invalid_argument);
  CHECK_THROWS_AS(choose_axis(BezierCurve({{1, 1, 1}, {1, 1, 1}})), std::invalid_argument);
  CHECK_THROWS_AS(is_strictly_monotone(space_cubic(), 3), std::invalid_argument);
}

TEST_CASE("both surfaces of every method contain the curve", "[space_curve_surfaces]") {
  const BezierCurve rational({{1, 0, 0}, {1, 1, 1}, {0, 1, 2}}, {1, 1, 2});
  for (const SpaceMethod method : {SpaceMethod::cylinders, SpaceMethod::orthogonal, SpaceMethod::root_free}) {
    for (const BezierCurve& curve : {space_cubic(), rational}) {
      SpaceOptions options;
      options.method = method;
      const SpaceImplicit result = implicitize_space(curve, options);
      INFO(name(method));
      CHECK(result.is_exact());
      CHECK(vanishes(result.surfaces.first, curve));
      CHECK(vanishes(result.surfaces.second, curve));
      CHECK_FALSE(result.surfaces.first == result.surfaces.second);
    }
  }
}

TEST_CASE("the angles are those of the independent computation", "[space_curve_surfaces]") {
  const auto cosine = [](const SpaceOptions& options) {
    const SpaceImplicit result = implicitize_space(space_cubic(), options);
    REQUIRE(result.angle.upper);
    CHECK(*result.angle.upper >= result.angle.lower);
    CHECK(*result.angle.upper - result.angle.lower < Rational(1, 1000));
    return to_double(*result.angle.upper);
  };
  CHECK(std::abs(cosine(options_of(SpaceMethod::cylinders)) - 0.5409) < 1e-3);
  CHECK(std::abs(cosine(options_of(SpaceMethod::orthogonal)) - 0.2028) < 1e-3);
  CHECK(std::abs(cosine(options_of(SpaceMethod::orthogonal, Rational(1, 1000))) - 0.1885) < 3e-3);
  CHECK(std::abs(cosine(options_of(SpaceMethod::orthogonal, 1000, 1)) - 0.7131) < 1e-3);
  CHECK(cosine(options_of(SpaceMethod::root_free)) == 0);
}

TEST_CASE("sum and difference of Algorithm 3 are multiples of the cylinders", "[space_curve_surfaces]") {
  const ProjectedPair pair = exact_projections(space_cubic(), 0);
  const BivariatePolynomial norm_f = BivariatePolynomial::r() + BivariatePolynomial::constant(3);
  const BivariatePolynomial norm_g = BivariatePolynomial::s() + BivariatePolynomial::constant(5);
  const SurfacePair plain = cylinders(pair);
  const SurfacePair surfaces = nearly_orthogonal(pair, norm_f, norm_g);
  CHECK(surfaces.first + surfaces.second == Rational(2) * (cylinder(norm_f, 0, 1) * plain.second));
  CHECK(surfaces.first - surfaces.second == Rational(2) * (cylinder(norm_g, 0, 2) * plain.first));
  CHECK(is_positive_on(norm_f, {{Rational(0), Rational(1)}, {Rational(0), Rational(1)}}));
  CHECK_FALSE(is_positive_on(norm_f, {{Rational(-4), Rational(1)}, {Rational(0), Rational(1)}}));
}

TEST_CASE("a gradient that vanishes has no angle", "[space_curve_surfaces]") {
  // f is a square.
  const ProjectedPair pair = exact_projections(space_cubic(), 0);
  const SurfacePair plain = cylinders(pair);
  const GradientAngle angle = largest_cosine({plain.first * plain.first, plain.second}, space_cubic());
  CHECK_FALSE(angle.upper);
}

TEST_CASE("the first-order distance is that from the line of two planes", "[space_curve_surfaces]") {
  const auto linear = [](const Point& n, const Rational& c) {
    return SpacePolynomial({{{1, 0, 0}, n[0]}, {{0, 1, 0}, n[1]}, {{0, 0, 1}, n[2]}, {{0, 0, 0}, c}});
  };
  const Point n = {1, 2, -1};
  const Point m = {3, 0, 2};
  const Point on_line = {Rational(1, 2), -1, Rational(2, 3)};
  const SurfacePair planes = {linear(n, -dot(n, on_line)), linear(m, -dot(m, on_line))};
  const Point direction = cross(n, m);
  for (const Point& p : {Point{0, 0, 0}, Point{5, Rational(-1, 3), 2}, on_line, on_line + direction}) {
    // The distance from a line through a point by the cross product, a route without gradients.
    const Point moment = cross(p - on_line, direction);
    const auto squared = first_order_squared_distance(planes, p);
    REQUIRE(squared);
    CHECK(*squared == dot(moment, moment) / dot(direction, direction));
  }
  CHECK_FALSE(first_order_squared_distance({planes.first, planes.first}, on_line));
  // The unit circle in z = 0, first order at distance h: (1 - (1+h)^2)^2 / (4 (1+h)^2) = h^2 + O(h^3).
  const SurfacePair circle = {SpacePolynomial({{{2, 0, 0}, 1}, {{0, 2, 0}, 1}, {{0, 0, 0}, -1}}),
                              SpacePolynomial::variable(2)};
  const Rational h(1, 1000);
  const auto near = first_order_squared_distance(circle, {1 + h, 0, 0});
  REQUIRE(near);
  CHECK(abs(*near / (h * h) - 1) < 3 * h);
}

}  // namespace exsect::space_curve_surfaces_test
