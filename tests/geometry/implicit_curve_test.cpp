#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/resultant.h>
#include <exsect/geometry/implicit_curve.h>
#include <exsect/geometry/polynomial_terms.h>

#include "curve_specimens.h"
#include "support/catch.h"

namespace exsect::implicit_curve_test {

namespace {

std::string equation_of(const BezierCurve& curve) {
  return to_text(terms_of(implicit_curve(curve).equation, "x", "y"));
}

bool vanishes_on(const BivariatePolynomial& f, const BezierCurve& curve) {
  return composed(f, homogeneous(curve)).is_zero();
}

/// The value at a point (x,y) of the resultant of X - x W and Y - y W.
Rational by_sylvester(const HomogeneousCurve& curve, const Rational& x, const Rational& y) {
  const Polynomial p = curve.numerators[0] - Polynomial(x) * curve.denominator;
  const Polynomial q = curve.numerators[1] - Polynomial(y) * curve.denominator;
  return resultant(p, q);
}

}  // namespace

TEST_CASE("equations of special curves", "[implicit_curve]") {
  CHECK(equation_of(quarter_circle()) == "x^2+y^2-1");
  CHECK(equation_of(BezierCurve({{0, 0}, {Rational(1, 2), 0}, {1, 1}})) == "x^2-y");
  CHECK(equation_of(BezierCurve({{0, 0}, {1, 1}})) == "x-y");
  CHECK(equation_of(BezierCurve({{2, 0}, {2, 1}})) == "x-2");
  CHECK(equation_of(BezierCurve({{0, 3}, {1, 3}})) == "y-3");
  // A cusp: (t^2, t^3).
  CHECK(equation_of(BezierCurve({{0, 0}, {0, 0}, {Rational(1, 3), 0}, {1, 1}})) == "x^3-y^2");
  CHECK_THROWS_AS(implicit_curve(BezierCurve({{1, 2}, {1, 2}})), std::invalid_argument);
  CHECK_THROWS_AS(implicit_curve(space_cubic()), std::invalid_argument);
}

TEST_CASE("the profile has the equation of the independent computation", "[implicit_curve]") {
  const ImplicitCurve curve = implicit_curve(profile_cubic());
  CHECK(curve.power == 1);
  // The reference's sign is the other one.
  CHECK(to_text(terms_of(curve.equation, "r", "z")) ==
        "8000*r^3+156000*r^2*z+1014000*r*z^2+2197000*z^3-236700*r^2-2151000*r*z-3749400*z^2+3735180*r+"
        "570510*z-830493");
}

TEST_CASE("the second profile has the equation of the independent computation", "[implicit_curve]") {
  const BezierCurve profile({{Rational(7, 10), Rational(1, 10)},
                             {Rational(13, 10), Rational(1, 2)},
                             {Rational(3, 2), Rational(3, 2)},
                             {Rational(1, 10), Rational(9, 5)}});
  CHECK(to_text(terms_of(implicit_curve(profile).equation, "r", "z")) ==
        "2197000*r^3-6084000*r^2*z+5616000*r*z^2-1728000*z^3+17547900*r^2-4118400*r*z+19310400*z^2-"
        "6669690*r-28611720*z-1466371");
}

TEST_CASE("a curve run through several times is detected", "[implicit_curve]") {
  // (t^2, t^4) and a cubic of a quadratic.
  const ImplicitCurve parabola =
      implicit_curve(BezierCurve({{0, 0}, {0, 0}, {Rational(1, 6), 0}, {Rational(1, 2), 0}, {1, 1}}));
  CHECK(parabola.power == 2);
  CHECK(to_text(terms_of(parabola.equation, "x", "y")) == "x^2-y");
  const ImplicitCurve line = implicit_curve(BezierCurve({{0, 0}, {0, 0}, {0, 0}, {1, 2}}));  // (t^3, 2 t^3)
  CHECK(line.power == 3);
  CHECK(line.equation.total_degree() == 1);
  // (x(s(t)), y(s(t))) with a cubic (x,y) and s = 3t - 2t^2: twice through a cubic.
  const Polynomial inner{0, 3, -2};
  const HomogeneousCurve cubic = homogeneous(profile_cubic());
  std::vector<std::vector<Rational>> points(7, std::vector<Rational>(2));
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<Rational> b = bernstein_coefficients(cubic.numerators[k].compose(inner), 6);
    for (std::size_t i = 0; i < 7; ++i) points[i][k] = b[i];
  }
  const ImplicitCurve twice = implicit_curve(BezierCurve(points));
  CHECK(twice.power == 2);
  CHECK(twice.equation == implicit_curve(profile_cubic()).equation);
}

TEST_CASE("random curves satisfy their equations", "[implicit_curve]") {
  const auto seed = 52u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 14; ++round) {
    const int degree = 1 + round % 7;
    const BezierCurve curve = random_curve(random, degree, 2, round >= 7);
    const ImplicitCurve implicit = implicit_curve(curve);
    CHECK(vanishes_on(implicit.equation, curve));
    CHECK(implicit.power * implicit.equation.total_degree() == degree);
    CHECK(implicit_curve(curve.reversed()).equation == implicit.equation);
    // Bezout's and Sylvester's determinants differ by a constant factor.
    const HomogeneousCurve reduced = homogeneous(curve);
    const Rational ratio = implicit.equation(3, 5) / by_sylvester(reduced, 3, 5);
    CHECK(implicit.equation(-7, 2) == ratio * by_sylvester(reduced, -7, 2));
  }
}

TEST_CASE("base points lower the degree", "[implicit_curve]") {
  // A quadratic whose control polygon is raised with a positive factor 1 + t.
  const HomogeneousCurve circle = homogeneous(quarter_circle());
  const Polynomial factor{1, 1};
  const std::vector<Rational> w = bernstein_coefficients(circle.denominator * factor, 3);
  std::vector<std::vector<Rational>> points(4);
  for (const Polynomial& numerator : circle.numerators) {
    const std::vector<Rational> b = bernstein_coefficients(numerator * factor, 3);
    for (std::size_t i = 0; i < 4; ++i) points[i].push_back(b[i] / w[i]);
  }
  const ImplicitCurve raised = implicit_curve(BezierCurve(points, w));
  CHECK(raised.power == 1);
  CHECK(to_text(terms_of(raised.equation, "x", "y")) == "x^2+y^2-1");
}

}  // namespace exsect::implicit_curve_test
