#include <exsect/geometry/implicit_curve.h>
#include <exsect/implicit/planar_fit.h>

#include <cmath>

#include "geometry/curve_specimens.h"
#include "support/catch.h"

namespace exsect::planar_fit_test {

namespace {

const PlanarBox box = {{Rational(0), Rational(2)}, {Rational(0), Rational(2)}};

/// The sum that is minimised, term by term.
Rational objective(const PlanarSpace& space, const std::vector<Rational>& c,
                   const std::vector<FitSample>& samples, const FitWeights& weights) {
  const PlanarFunction f = space.combination(c);
  Rational sum = 0;
  if (weights.w2 != 0) {
    const RationalMatrix tension = space.tension();
    for (std::size_t i = 0; i < c.size(); ++i)
      for (std::size_t j = 0; j < c.size(); ++j) sum += weights.w2 * c[i] * tension(i, j) * c[j];
  }
  for (const FitSample& p : samples) {
    const BivariatePolynomial g = f.polynomials_on({{p.x, p.x}, {p.y, p.y}}).front();
    const Rational value = g(p.x, p.y), dx = g.derivative_r()(p.x, p.y) - p.normal_x,
                   dy = g.derivative_s()(p.x, p.y) - p.normal_y;
    sum += value * value + weights.w1 * (dx * dx + dy * dy);
  }
  return sum;
}

}  // namespace

TEST_CASE("samples lie on the curve with nearly unit normals", "[planar_fit]") {
  for (const BezierCurve& curve : {profile_cubic(), quarter_circle()}) {
    const std::vector<FitSample> samples = fit_samples(curve, 11);
    REQUIRE(samples.size() == 11);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const Rational t(static_cast<int>(k), 10);
      CHECK(curve(t) == std::vector<Rational>{samples[k].x, samples[k].y});
      const Rational square =
          samples[k].normal_x * samples[k].normal_x + samples[k].normal_y * samples[k].normal_y;
      CHECK(square <= 1);
      CHECK(square > 1 - power_of_two(-36));
    }
  }
  // On the circle the normal (-y', x') is -p.
  for (const FitSample& p : fit_samples(quarter_circle(), 5))
    CHECK(abs(p.normal_x + p.x) + abs(p.normal_y + p.y) < power_of_two(-36));
  CHECK(fit_samples(BezierCurve({{0, 0}, {0, 0}, {1, 1}}), 2)[0].normal_x == 0);  // no tangent at t = 0
  CHECK_THROWS_AS(fit_samples(space_cubic(), 5), std::invalid_argument);
  CHECK_THROWS_AS(fit_samples(BezierCurve({{1, 1}, {1, 1}}), 5), std::invalid_argument);
  CHECK_THROWS_AS(fit_samples(profile_cubic(), 1), std::invalid_argument);
}

TEST_CASE("the fits of the profile are those of the independent computation", "[planar_fit]") {
  const std::vector<FitSample> samples = fit_samples(profile_cubic(), 21);
  const char* direct[] = {"333457", "-1274637", "-628686", "-641926",  "3169538",
                          "724688", "-511887",  "323332",  "-1640221", "-268137"};
  const char* in_squares[] = {"93326",  "-2476360", "44054", "265082",   "3851838",
                              "369074", "-715741",  "25954", "-1817896", "-264259"};
  for (const bool squared : {false, true}) {
    PlanarSpace space = PlanarSpace::monomials(3, box);
    if (squared) space = space.in_squares();
    for (const Arithmetic arithmetic : {Arithmetic::exact, Arithmetic::floating}) {
      const PlanarFit fit = fit_points_and_normals(space, samples, {}, arithmetic);
      CHECK(fit.is_unique);
      CHECK(rounding_digits(space, samples, fit.coefficients) == 6);
      const std::vector<Rational> c = rounded_coefficients(fit.coefficients, 6);
      for (std::size_t i = 0; i < 10; ++i)
        CHECK(c[i] == Rational(Integer((squared ? in_squares : direct)[i]), 1000000));
    }
  }
}

TEST_CASE("no other function of the space is better", "[planar_fit]") {
  const auto seed = 71u;
  INFO("seed " << seed);
  Random random(seed);
  const std::vector<FitSample> samples = fit_samples(profile_cubic(), 21);
  const FitWeights weights = {Rational(1, 3), Rational(1, 100)};
  const PlanarSpace spaces[] = {
      PlanarSpace::monomials(2, box), PlanarSpace::bernstein(2, 2, box),
      PlanarSpace::b_splines(2, 2, {{Rational(0), Rational(1)}, {Rational(0), Rational(3, 2)}}, 3, 4,
                             profile_cubic())};
  for (const PlanarSpace& space : spaces) {
    const PlanarFit fit = fit_points_and_normals(space, samples, weights, Arithmetic::exact);
    const Rational best = objective(space, fit.coefficients, samples, weights);
    for (int round = 0; round < 3; ++round) {
      std::vector<Rational> other = fit.coefficients;
      for (Rational& c : other) c += random_rational(random) / 1000;
      CHECK(objective(space, other, samples, weights) >= best);
    }
    const PlanarFit rounded = fit_points_and_normals(space, samples, weights, Arithmetic::floating);
    const Rational near = objective(space, rounded.coefficients, samples, weights);
    CHECK(near >= best);
    CHECK(near - best < power_of_two(-40));
  }
}

TEST_CASE("with small w1 the fit tends to the exact equation", "[planar_fit]") {
  const PlanarSpace space = PlanarSpace::monomials(3, box);
  const std::vector<FitSample> samples = fit_samples(profile_cubic(), 21);
  const Rational w1 = Rational(1, pow(Integer(10), 12u));
  const std::vector<Rational> c =
      fit_points_and_normals(space, samples, {w1, 0}, Arithmetic::exact).coefficients;
  const BivariatePolynomial f = space.combination(c).polynomial();
  const BivariatePolynomial exact = implicit_curve(profile_cubic()).equation;
  // Scaled to the same largest coefficient, that of z^2.
  const Rational scale = f.coefficient(0, 2) / exact.coefficient(0, 2);
  Rational error = 0;
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; i + j <= 3; ++j)
      error = std::max<Rational>(error, abs(f.coefficient(i, j) / scale / exact.coefficient(0, 2) -
                                            exact.coefficient(i, j) / exact.coefficient(0, 2)));
  CHECK(error < Rational(5, 100000));
  CHECK(error > Rational(1, 1000000));
}

TEST_CASE("tension flattens, and decides what samples leave open", "[planar_fit]") {
  // On a line every multiple of its square is free.
  const BezierCurve line({{0, 0}, {1, 1}});
  const std::vector<FitSample> samples = fit_samples(line, 9);
  const PlanarSpace space = PlanarSpace::monomials(2, box);
  const PlanarFit open = fit_points_and_normals(space, samples, {}, Arithmetic::exact);
  CHECK_FALSE(open.is_unique);
  CHECK(objective(space, open.coefficients, samples, {}) < power_of_two(-60));
  CHECK_FALSE(fit_points_and_normals(space, samples, {}, Arithmetic::floating).is_unique);
  const PlanarFit tense = fit_points_and_normals(space, samples, {1, 1}, Arithmetic::exact);
  CHECK(tense.is_unique);
  CHECK(space.combination(tense.coefficients).polynomial().total_degree() == 1);
  const PlanarFit same = fit_points_and_normals(space, samples, {1, 1}, Arithmetic::floating);
  for (std::size_t i = 0; i < space.dimension(); ++i)
    CHECK(std::abs(to_double(Rational(same.coefficients[i] - tense.coefficients[i]))) < 1e-10);
}

TEST_CASE("weights outside their range are refused", "[planar_fit]") {
  const PlanarSpace space = PlanarSpace::monomials(1, box);
  const std::vector<FitSample> samples = fit_samples(profile_cubic(), 3);
  CHECK_THROWS_AS(fit_points_and_normals(space, samples, {0, 0}, Arithmetic::exact), std::invalid_argument);
  CHECK_THROWS_AS(fit_points_and_normals(space, samples, {1, -1}, Arithmetic::exact), std::invalid_argument);
  CHECK_THROWS_AS(fit_points_and_normals(space, {}, {}, Arithmetic::exact), std::invalid_argument);
}

TEST_CASE("coefficients are rounded to the nearest decimal", "[planar_fit]") {
  CHECK(rounded_coefficients({Rational(1, 3), Rational(-2, 3), Rational(1, 20), 0}, 1) ==
        std::vector<Rational>{Rational(3, 10), Rational(-7, 10), Rational(1, 10), 0});
  // Nothing is rounded where the function vanishes at all samples.
  const PlanarSpace space = PlanarSpace::monomials(1, box);
  CHECK_FALSE(rounding_digits(space, fit_samples(BezierCurve({{0, 0}, {1, 1}}), 3), {0, 1, -1}));
}

}  // namespace exsect::planar_fit_test
