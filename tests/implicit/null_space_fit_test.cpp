#include <exsect/algebra/bernstein.h>
#include <exsect/geometry/implicit_curve.h>
#include <exsect/implicit/implicit_bounds.h>
#include <exsect/implicit/null_space_fit.h>

#include <array>
#include <cmath>

#include "geometry/curve_specimens.h"
#include "support/catch.h"

namespace exsect::null_space_fit_test {

namespace {

const PlanarBox box = {{Rational(0), Rational(2)}, {Rational(0), Rational(2)}};
constexpr std::array all_bases = {CurveBasis::bernstein, CurveBasis::legendre, CurveBasis::chebyshev,
                                  CurveBasis::lagrange};

/// The part of a curve over [0,h].
BezierCurve beginning(const BezierCurve& curve, const Rational& h) {
  const HomogeneousCurve whole = homogeneous(curve);
  const int n = whole.degree();
  const std::vector<Rational> w = bernstein_coefficients(whole.denominator, n, 0, h);
  std::vector<std::vector<Rational>> points(w.size());
  for (const Polynomial& numerator : whole.numerators) {
    const std::vector<Rational> b = bernstein_coefficients(numerator, n, 0, h);
    for (std::size_t i = 0; i < b.size(); ++i) points[i].push_back(b[i] / w[i]);
  }
  return BezierCurve(points, w);
}

/// A curve without equation of degree 4 or less.
BezierCurve sextic() {
  return BezierCurve({{0, 0},
                      {Rational(1, 6), 0},
                      {Rational(1, 3), Rational(1, 9)},
                      {Rational(1, 2), Rational(1, 3)},
                      {Rational(2, 3), Rational(5, 7)},
                      {1, 1},
                      {Rational(4, 3), Rational(9, 7)}});
}

}  // namespace

TEST_CASE("the rank over Q decides whether a degree is exact", "[null_space_fit]") {
  for (const CurveBasis basis : all_bases) {
    for (const Arithmetic arithmetic : {Arithmetic::exact, Arithmetic::floating}) {
      INFO(name(basis));
      const NullSpaceFit below =
          fit_null_space(PlanarSpace::monomials(2, box), profile_cubic(), basis, arithmetic);
      CHECK(below.nullity == 0);
      CHECK(below.singular_value > 0);
      const PlanarSpace cubics = PlanarSpace::monomials(3, box);
      const NullSpaceFit exact = fit_null_space(cubics, profile_cubic(), basis, arithmetic);
      CHECK(exact.nullity == 1);
      CHECK(exact.singular_value == 0);
      const BivariatePolynomial f = cubics.combination(exact.coefficients).polynomial();
      const BivariatePolynomial g = implicit_curve(profile_cubic()).equation;
      CHECK(f * g.coefficient(0) == g * f.coefficient(0));  // both factors are polynomials in y
      // Degree 4: the equation times the three polynomials of degree 1.
      CHECK(fit_null_space(PlanarSpace::monomials(4, box), profile_cubic(), basis, arithmetic).nullity == 3);
    }
  }
  CHECK(fit_null_space(PlanarSpace::monomials(2, box), quarter_circle(), CurveBasis::bernstein,
                       Arithmetic::floating)
            .nullity == 1);
}

TEST_CASE("on the curve a Bernstein fit is at most its singular value", "[null_space_fit]") {
  for (const Arithmetic arithmetic : {Arithmetic::exact, Arithmetic::floating}) {
    for (int degree = 1; degree <= 4; ++degree) {
      const PlanarSpace space = PlanarSpace::local_monomials(degree, box);
      const NullSpaceFit fit = fit_null_space(space, sextic(), CurveBasis::bernstein, arithmetic);
      const OneSidedBound bound = one_sided_bound(space.combination(fit.coefficients), sextic());
      REQUIRE(bound.residual);
      CHECK(to_double(*bound.residual) <= fit.singular_value * (1 + 1e-9));
      CHECK(to_double(*bound.residual) > fit.singular_value / 50);
    }
  }
}

TEST_CASE("the weak form has the least integral of the square", "[null_space_fit]") {
  const PlanarSpace space = PlanarSpace::monomials(2, box);
  const auto integral = [&](CurveBasis basis) {
    const NullSpaceFit fit = fit_null_space(space, sextic(), basis, Arithmetic::exact);
    const Polynomial f = composed(space.combination(fit.coefficients).polynomial(), homogeneous(sextic()));
    const std::vector<Rational> square = bernstein_coefficients(f * f, 2 * f.degree());
    Rational sum = 0;
    for (const Rational& b : square) sum += b;
    Rational length = 0;
    for (const Rational& c : fit.coefficients) length += c * c;
    return to_double(Rational(sum / static_cast<int>(square.size()) / length));
  };
  const double least = integral(CurveBasis::legendre);
  for (const CurveBasis basis : {CurveBasis::bernstein, CurveBasis::chebyshev, CurveBasis::lagrange})
    CHECK(integral(basis) > least);
  // The integral is the square of the singular value.
  const double sigma =
      fit_null_space(space, sextic(), CurveBasis::legendre, Arithmetic::exact).singular_value;
  CHECK(std::abs(least / (sigma * sigma) - 1) < 1e-9);
  const double rounded =
      fit_null_space(space, sextic(), CurveBasis::legendre, Arithmetic::floating).singular_value;
  CHECK(std::abs(rounded / sigma - 1) < 1e-6);
}

TEST_CASE("the orders of convergence are 2, 5, 9, 14", "[null_space_fit]") {
  const int expected[] = {2, 5, 9, 14};
  for (const CurveBasis basis : {CurveBasis::bernstein, CurveBasis::legendre}) {
    for (int degree = 1; degree <= 4; ++degree) {
      const PlanarSpace space = PlanarSpace::monomials(degree, box);
      const auto sigma = [&](const Rational& h) {
        return fit_null_space(space, beginning(sextic(), h), basis, Arithmetic::exact).singular_value;
      };
      const double order = std::log2(sigma(Rational(1, 32)) / sigma(Rational(1, 64)));
      INFO(name(basis) << ", degree " << degree);
      CHECK(std::abs(order - expected[degree - 1]) < 0.25);
    }
  }
}

TEST_CASE("what has no null space fit is refused", "[null_space_fit]") {
  const PlanarSpace space = PlanarSpace::monomials(2, box);
  const auto fit = [](const PlanarSpace& in, const BezierCurve& curve) {
    return fit_null_space(in, curve, CurveBasis::bernstein, Arithmetic::floating);
  };
  CHECK_THROWS_AS(fit(space, space_cubic()), std::invalid_argument);
  CHECK_THROWS_AS(fit(space, BezierCurve({{1, 1}, {1, 1}})), std::invalid_argument);
  CHECK_THROWS_AS(fit(PlanarSpace::b_splines(2, 2, box, 4, 4, profile_cubic()), profile_cubic()),
                  std::invalid_argument);
}

}  // namespace exsect::null_space_fit_test
