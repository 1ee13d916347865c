#include "lift/chart_tangents.h"

#include <array>
#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::chart_tangents_test {

TEST_CASE("polynomials over rectangles contain their exact values", "[lift]") {
  const unsigned seed = 8;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int k = 0; k < 300; ++k) {
    const int m = k % 5, n = k / 5 % 6;
    BivariatePolynomial f, power_u = BivariatePolynomial::constant(1);
    for (int i = 0; i <= m; ++i) {
      BivariatePolynomial power = power_u;
      for (int j = 0; j <= n; ++j) {
        f += power * BivariatePolynomial::constant(from_double(number(generator)) / 3);
        power = power * BivariatePolynomial::s();
      }
      power_u = power_u * BivariatePolynomial::r();
    }
    const double u = 2 * number(generator), v = 2 * number(generator);
    const double reach = k % 3 == 0 ? 0 : k % 3 == 1 ? 0x1p-10 : 0.25;
    const RationalInterval all =
        PolynomialInBalls(f, Rational(1, 7)).over(DoubleBall(u, reach), DoubleBall(v, reach)).interval();
    for (const double a : {-reach, reach * 0.3, reach})
      for (const double b : {-reach, reach * 0.7, reach}) {
        const Rational value = 7 * f(from_double(u) + from_double(a), from_double(v) + from_double(b));
        CHECK(all.lower <= value);
        CHECK(value <= all.upper);
      }
    if (reach < 0.1) CHECK(to_double(all.width()) < 1e5 * reach + 1e-9);
  }
}

TEST_CASE("polynomials over rectangles: cancellation and overflow prove nothing", "[lift]") {
  // (r - 1/3)^8 takes values below the errors of doubles about 1/3.
  BivariatePolynomial power = BivariatePolynomial::constant(1);
  for (int k = 0; k < 8; ++k)
    power = power * (BivariatePolynomial::r() - BivariatePolynomial::constant(Rational(1, 3)));
  CHECK(PolynomialInBalls(power, 1).over(0.34, 0.0).certain_sign() == 0);
  CHECK(PolynomialInBalls(power, 1).over(0.9, 0.0).is_positive());
  const DoubleBall beyond = PolynomialInBalls(power, 1).over(1e100, 0.0);
  CHECK(beyond.certain_sign() == 0);
  CHECK(beyond.lower_magnitude() == 0);
}

// g = v - u - c u^2 as it is, and with u and v exchanged, where the other quotient bounds Y.
TEST_CASE("Y between two points of an arc contains its exact values, and little more", "[lift]") {
  const unsigned seed = 21;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> digit(-9, 9), place(0, 90);
  const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
  const auto number = [](const Rational& c) { return BivariatePolynomial::constant(c); };
  for (int k = 0; k < 400; ++k) {
    const Rational c(digit(generator) + 9, 6);
    const bool is_exchanged = k % 2 == 1;
    const BivariatePolynomial g = s - r - number(c) * r * r;
    SurfaceChart chart;
    chart.radicand = number(digit(generator)) + number(digit(generator)) * r +
                     number(digit(generator)) * r * r + number(digit(generator)) * s +
                     number(digit(generator)) * s * s;
    const ChartTangents tangents(is_exchanged ? g.exchanged() : g, chart, false);
    const Rational from(place(generator), 100), step = power_of_two(-(k % 12) - 2);
    const auto at = [&](int i) {
      const Rational t = from + step * Rational(i, 8), on = t + c * t * t;
      return is_exchanged ? std::array{on, t} : std::array{t, on};
    };
    const auto square = [&](int i) { return chart.radicand(at(i)[0], at(i)[1]); };
    const auto range = [&](std::size_t i) {
      return DoubleBall::enclosing(RationalInterval{at(0)[i], at(8)[i]});
    };
    const DoubleBall u = range(0), v = range(1);
    const ChartRates rates =
        tangents.rates(u, v, to_double(at(8)[0] - at(0)[0]), to_double(at(8)[1] - at(0)[1]));
    const DoubleBall all = squares_between(DoubleBall::enclosing(square(0)), DoubleBall::enclosing(square(8)),
                                           rates, 2 * u.radius(), 2 * v.radius());
    for (int i = 0; i <= 8; ++i) {
      CHECK(all.interval().lower <= square(i));
      CHECK(square(i) <= all.interval().upper);
      const DoubleBall slope = DoubleBall::enclosing(Rational(1 + 2 * c * (from + step * Rational(i, 8))));
      const DoubleBall off = is_exchanged ? rates.v * slope - rates.u : rates.u * slope - rates.v;
      CHECK(std::isfinite(off.radius()));
      CHECK(off.certain_sign() == 0);
    }
    // The rate changes by less than 2000 times the step.
    CHECK(all.radius() <= to_double(abs(square(8) - square(0))) / 2 + 2000 * to_double(step * step) + 1e-12);
  }
}

// (v - u - u^2/8)^2 = 10^-8: the gradient changes by a tenth on the rectangle, its direction by 10^-6.
TEST_CASE("the direction of an arc beside another one is known well", "[lift]") {
  const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
  const BivariatePolynomial f = s - r - BivariatePolynomial::constant(Rational(1, 8)) * r * r;
  SurfaceChart chart;
  chart.radicand = r + s;
  for (const bool is_exchanged : {false, true}) {
    const BivariatePolynomial g = f * f - BivariatePolynomial::constant(Rational(1, 100000000));
    const ChartTangents tangents(is_exchanged ? g.exchanged() : g, chart, false);
    const double a = 0.3, b = a + 1e-5, rise = 1 + (a + b) / 8;
    const DoubleBall u((a + b) / 2, 5e-6), v((a + b) / 2 * (1 + (a + b) / 16) + 1e-4, 5.4e-6);
    const ChartRates rates =
        is_exchanged ? tangents.rates(v, u, rise * 1e-5, 1e-5) : tangents.rates(u, v, 1e-5, rise * 1e-5);
    const DoubleBall slope = is_exchanged ? rates.v : rates.u;  // of u, for a unit of v
    CHECK(rates.is_steep != is_exchanged);
    CHECK(std::fabs(slope.approximation() - 1 / rise) < 1e-5);
    CHECK(slope.radius() < 1e-4);
  }
}

TEST_CASE("Y is not known where both derivatives of the curve may vanish", "[lift]") {
  const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
  SurfaceChart chart;
  chart.radicand = r + s;
  const ChartTangents tangents(r * r - s * s, chart, false);
  const DoubleBall about(0, 0.5), one(1);
  CHECK_FALSE(std::isfinite(squares_between(one, one, tangents.rates(about, about, 1, 0.5), 1, 1).radius()));
  CHECK_FALSE(std::isfinite(squares_between(one, one, tangents.rates(about, about, 0.5, 1), 1, 1).radius()));
  CHECK_FALSE(std::isfinite(squares_between(one, one, tangents.rates(one, one, 0, 0), 1, 1).radius()));
  CHECK(std::isfinite(squares_between(one, one, tangents.rates(about, one, 1, 0.5), 1, 1).radius()));
}

}  // namespace exsect::chart_tangents_test
