#include <exsect/algebra/bernstein.h>
#include <exsect/geometry/implicit_curve.h>
#include <exsect/implicit/implicit_bounds.h>
#include <exsect/implicit/planar_fit.h>

#include <algorithm>
#include <cmath>

#include "geometry/curve_specimens.h"
#include "support/catch.h"

namespace exsect::implicit_bounds_test {

namespace {

const PlanarBox box = {{Rational(0), Rational(2)}, {Rational(0), Rational(2)}};

PlanarFunction cubic_fit(bool squared) {
  PlanarSpace space = PlanarSpace::monomials(3, box);
  if (squared) space = space.in_squares();
  const PlanarFit fit =
      fit_points_and_normals(space, fit_samples(profile_cubic(), 21), {}, Arithmetic::exact);
  return space.combination(rounded_coefficients(fit.coefficients, 6));
}

/// The largest distance of points of the curve from zeros of f that Newton's method along the gradient finds:
/// not below the true distance of any of these points.
double sampled_distance(const PlanarFunction& f, const BezierCurve& curve) {
  double largest = 0;
  for (int k = 0; k <= 40; ++k) {
    const std::vector<Rational> p = curve(Rational(k, 40));
    Rational x = p[0], y = p[1];
    for (int step = 0; step < 8; ++step) {
      const BivariatePolynomial g = f.polynomials_on({{x, x}, {y, y}}).front();
      const Rational dx = g.derivative_r()(x, y), dy = g.derivative_s()(x, y);
      const Rational factor = g(x, y) / (dx * dx + dy * dy);
      x = from_double(to_double(x - factor * dx));
      y = from_double(to_double(y - factor * dy));
    }
    largest = std::max(largest, std::hypot(to_double(Rational(x - p[0])), to_double(Rational(y - p[1]))));
  }
  return largest;
}

}  // namespace

TEST_CASE("the distances of the profile are not above those of the independent computation",
          "[implicit_bounds]") {
  const double one_sided[] = {0.0085112, 0.0051141};
  const double two_sided[] = {203.0 / 40000 * 1.92094, 1.0 / 320 * 1.92094};
  for (const bool squared : {false, true}) {
    const PlanarFunction f = cubic_fit(squared);
    const DistanceBounds bounds = distance_bounds(f, profile_cubic());
    REQUIRE(bounds.one_sided.distance);
    REQUIRE(bounds.two_sided.strip);
    CHECK(bounds.one_sided.unproved.empty());
    const double distance = to_double(*bounds.one_sided.distance);
    const double sampled = sampled_distance(f, profile_cubic());
    CHECK(distance <= one_sided[squared ? 1 : 0]);
    CHECK(distance >= sampled);
    CHECK(distance < 1.2 * sampled);
    const double strip = to_double(bounds.two_sided.strip->distance);
    CHECK(strip <= 1.002 * two_sided[squared ? 1 : 0]);
    CHECK(strip >= sampled);
    // Everywhere on the curve |f| is at most the residual.
    for (int k = 0; k <= 50; ++k) {
      const std::vector<Rational> p = profile_cubic()(Rational(k, 50));
      CHECK(abs(*f(p[0], p[1])) <= *bounds.one_sided.residual);
    }
  }
}

TEST_CASE("the strip holds one zero on every normal", "[implicit_bounds]") {
  const PlanarFunction f = cubic_fit(false);
  const auto bound = two_sided_bound(f, profile_cubic());
  REQUIRE(bound.strip);
  const HomogeneousCurve curve = homogeneous(profile_cubic());
  for (int k = 0; k <= 20; ++k) {
    const Rational t(k, 20);
    const Rational nx = -curve.numerators[1].derivative()(t), ny = curve.numerators[0].derivative()(t);
    std::vector<int> signs;
    for (int i = -8; i <= 8; ++i) {
      const Rational s = bound.strip->half_width * i / 8;
      signs.push_back(sign(*f(curve.numerators[0](t) + s * nx, curve.numerators[1](t) + s * ny)));
    }
    CHECK(signs.front() * signs.back() == -1);
    int changes = 0;
    for (std::size_t i = 0; i + 1 < signs.size(); ++i) changes += signs[i] != signs[i + 1] ? 1 : 0;
    CHECK(changes <= 2);  // a zero value counts twice
  }
}

TEST_CASE("an exact equation has distance zero", "[implicit_bounds]") {
  for (const BezierCurve& curve : {profile_cubic(), quarter_circle(), BezierCurve({{0, 0}, {0, 1}})}) {
    const DistanceBounds bounds = distance_bounds(implicit_curve(curve).equation, curve);
    CHECK(bounds.one_sided.distance == Rational(0));
    CHECK(bounds.one_sided.residual == Rational(0));
    REQUIRE(bounds.two_sided.strip);
    CHECK(bounds.two_sided.strip->distance == 0);
    CHECK(bounds.two_sided.strip->half_width > 0);
  }
}

TEST_CASE("a rational curve against a nearby conic", "[implicit_bounds]") {
  // The circle of radius 1 against that of radius 1 + e: the distance is e.
  const Rational e(1, 1000);
  const BivariatePolynomial x = BivariatePolynomial::r(), y = BivariatePolynomial::s();
  const BivariatePolynomial f = x * x + y * y - BivariatePolynomial::constant((1 + e) * (1 + e));
  const DistanceBounds bounds = distance_bounds(f, quarter_circle());
  REQUIRE(bounds.one_sided.distance);
  REQUIRE(bounds.two_sided.strip);
  CHECK(*bounds.one_sided.distance >= e);
  CHECK(*bounds.one_sided.distance < e * Rational(51, 50));
  CHECK(bounds.two_sided.strip->distance >= e);
  // |N| varies along the curve by a factor of 2.
  CHECK(bounds.two_sided.strip->distance < 3 * e);
}

TEST_CASE("a denominator with Bernstein coefficients below zero", "[implicit_bounds]") {
  // The quarter circle with all coordinates multiplied by 4 t^2 - 3 t + 1 > 0 (coefficients 1, -1/2, 2): a
  // common factor, removed at once, and the same factor in the denominator only.
  const Polynomial factor{1, -3, 4};
  const Polynomial w = Polynomial{1, 0, 1} * factor;
  const std::vector<Rational> weights = bernstein_coefficients(w, 6);
  REQUIRE(*std::min_element(weights.begin(), weights.end()) > 0);
  std::vector<std::vector<Rational>> points(7);
  for (const Polynomial& numerator : {Polynomial{1, 0, 1}, Polynomial{0, 1, 0, 1}}) {
    const std::vector<Rational> b = bernstein_coefficients(numerator, 6);
    for (std::size_t i = 0; i < 7; ++i) points[i].push_back(b[i] / weights[i]);
  }
  const BezierCurve curve(points, weights);
  REQUIRE(homogeneous(curve).denominator.degree() == 2);
  // The exact equation of (1, t)/(4 t^2 - 3 t + 1), displaced.
  const BivariatePolynomial exact = implicit_curve(curve).equation;
  const BivariatePolynomial f = exact + BivariatePolynomial::constant(Rational(1, 1000));
  const DistanceBounds bounds = distance_bounds(f, curve);
  REQUIRE(bounds.one_sided.residual);
  CHECK(*bounds.one_sided.residual >= Rational(1, 1000));
  CHECK(*bounds.one_sided.residual < Rational(3, 1000));
  REQUIRE(bounds.one_sided.distance);
  CHECK(to_double(*bounds.one_sided.distance) >= 0.999 * sampled_distance(f, curve));
}

TEST_CASE("what cannot be proved is said with its place", "[implicit_bounds]") {
  // The product of two lines: singular in the middle of the curve.
  const BivariatePolynomial x = BivariatePolynomial::r(), y = BivariatePolynomial::s();
  const BivariatePolynomial cross = x * x - y * y + BivariatePolynomial::constant(power_of_two(-20));
  const BezierCurve diagonal({{-1, -1}, {1, 1}});
  const DistanceBounds bounds = distance_bounds(cross, diagonal);
  CHECK_FALSE(bounds.one_sided.distance);
  CHECK(bounds.one_sided.residual);
  REQUIRE(bounds.one_sided.unproved.size() == 1);
  CHECK(bounds.one_sided.unproved[0].t.lower <= Rational(1, 2));
  CHECK(bounds.one_sided.unproved[0].t.upper >= Rational(1, 2));
  CHECK(bounds.one_sided.unproved[0].t.width() < Rational(1, 8));
  CHECK_FALSE(bounds.two_sided.strip);
  CHECK(bounds.two_sided.unproved.size() == 1);
  // The curve has a cusp: its normal segments fold.
  const BezierCurve cusp({{0, 0}, {0, 0}, {Rational(1, 3), 0}, {1, 1}});
  const TwoSidedBound folded = two_sided_bound(implicit_curve(cusp).equation, cusp);
  CHECK_FALSE(folded.strip);
  CHECK(folded.unproved[0].t.lower == 0);
  CHECK(folded.unproved[0].why.find("fold") != std::string::npos);
  // No zero at all.
  const DistanceBounds none = distance_bounds(BivariatePolynomial::constant(1), diagonal);
  CHECK_FALSE(none.one_sided.distance);
  CHECK_FALSE(none.two_sided.strip);
  CHECK_THROWS_AS(distance_bounds(cross, space_cubic()), std::invalid_argument);
  CHECK_THROWS_AS(distance_bounds(cross, BezierCurve({{1, 1}, {1, 1}})), std::invalid_argument);
}

TEST_CASE("a strip proves the one-sided distance too", "[implicit_bounds]") {
  // A conic so near to two lines that the gradient has no good lower bound on boxes.
  const BivariatePolynomial x = BivariatePolynomial::r(), y = BivariatePolynomial::s();
  const auto c = [](int numerator, int denominator) {
    return BivariatePolynomial::constant(Rational(numerator, denominator));
  };
  const BivariatePolynomial f = c(204459, 250000) * x * x + c(78843, 500000) * x * y -
                                c(230757, 500000) * y * y - c(2948121, 2000000) * x + c(339151, 400000) * y +
                                c(560671, 4000000);
  CHECK_FALSE(one_sided_bound(f, profile_cubic()).distance);
  const DistanceBounds bounds = distance_bounds(f, profile_cubic());
  REQUIRE(bounds.two_sided.strip);
  CHECK(bounds.one_sided.distance == bounds.two_sided.strip->distance);
  CHECK(bounds.one_sided.unproved.empty());
}

TEST_CASE("bounds of splines", "[implicit_bounds]") {
  const PlanarBox near = {{Rational(0), Rational(1)}, {Rational(0), Rational(3, 2)}};
  const PlanarSpace space = PlanarSpace::b_splines(2, 2, near, 5, 7, profile_cubic());
  const PlanarFit fit = fit_points_and_normals(space, fit_samples(profile_cubic(), 61),
                                               {1, Rational(1, 1000)}, Arithmetic::floating);
  const PlanarFunction f = space.combination(rounded_coefficients(fit.coefficients, 8));
  const DistanceBounds bounds = distance_bounds(f, profile_cubic());
  REQUIRE(bounds.one_sided.distance);
  REQUIRE(bounds.two_sided.strip);
  const double sampled = sampled_distance(f, profile_cubic());
  CHECK(to_double(*bounds.one_sided.distance) >= sampled);
  CHECK(to_double(*bounds.one_sided.distance) < 1.5 * sampled);
  // Beyond the cells nothing is defined.
  const PlanarSpace small = PlanarSpace::b_splines(2, 2, near, 5, 7, BezierCurve({{0, 0}, {1, 0}}));
  const PlanarFunction elsewhere = small.combination(std::vector<Rational>(small.dimension(), 1));
  const DistanceBounds undefined = distance_bounds(elsewhere, profile_cubic());
  CHECK_FALSE(undefined.one_sided.distance);
  CHECK_FALSE(undefined.one_sided.residual);
  REQUIRE_FALSE(undefined.one_sided.unproved.empty());
  CHECK(undefined.one_sided.unproved.back().t.upper == 1);
  CHECK(undefined.one_sided.unproved.back().why.find("not defined") != std::string::npos);
}

TEST_CASE("singular points are excluded or enclosed", "[implicit_bounds]") {
  const BivariatePolynomial x = BivariatePolynomial::r(), y = BivariatePolynomial::s();
  const PlanarBox around = {{Rational(-1), Rational(1)}, {Rational(-1), Rational(3, 2)}};
  CHECK(possibly_singular(x * x + y * y - BivariatePolynomial::constant(1), around).empty());
  // The node of x^3 + x^2 - y^2 at the origin.
  const std::vector<PlanarBox> node = possibly_singular(x * x * x + x * x - y * y, around);
  REQUIRE_FALSE(node.empty());
  for (const PlanarBox& b : node) {
    CHECK(abs(b.x.lower) < Rational(1, 1000));
    CHECK(abs(b.y.upper) < Rational(1, 1000));
  }
  // The exact equation of the profile has its double point outside the square of the fit.
  CHECK(possibly_singular(cubic_fit(false), box).empty());
}

}  // namespace exsect::implicit_bounds_test
