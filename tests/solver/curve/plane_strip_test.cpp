// Strips that a plane curve does not meet: in doubles and in long numbers, and against exact values.
#include "curve/plane_strip.h"

#include <exsect/algebra/double_double_ball.h>
#include <exsect/algebra/real_algebraic.h>

#include <random>

#include "support/catch.h"

namespace exsect::plane_strip_test {
namespace {

BivariatePolynomial random_curve(std::mt19937& generator, int m, int n) {
  std::uniform_int_distribution<int> digit(-99, 99);
  std::vector<Polynomial> rows;
  for (int i = 0; i <= m; ++i) {
    std::vector<Rational> row;
    for (int j = 0; j <= n; ++j) row.emplace_back(digit(generator), 7);
    rows.emplace_back(row);
  }
  return BivariatePolynomial(rows);
}

template <class Ball>
std::optional<double> clear(const BivariatePolynomial& f, double u0, double v0, double u1, double v1,
                            double w) {
  return PlaneStrip<Ball>(f).clear({Ball(u0), Ball(v0)}, {Ball(u1), Ball(v1)}, w, 0);
}

}  // namespace

TEST_CASE("plane strips: doubles prove what long numbers prove, and no more", "[curve]") {
  const unsigned seed = 11;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0, 1);
  int proved = 0, only_long = 0;
  for (int i = 0; i < 400; ++i) {
    const int m = 1 + i % 12, n = 1 + i % 8;
    const BivariatePolynomial f = random_curve(generator, m, n);
    const double u0 = place(generator), v0 = place(generator);
    const double u1 = u0 + 1e-3 * (place(generator) - 0.5), v1 = v0 + 1e-3 * (place(generator) - 0.5);
    const double w = 1e-4 * place(generator);
    const auto in_doubles = clear<DoubleBall>(f, u0, v0, u1, v1, w);
    const auto in_long_numbers = clear<ArbBall<256>>(f, u0, v0, u1, v1, w);
    proved += in_doubles ? 1 : 0;
    only_long += in_long_numbers && !in_doubles ? 1 : 0;
    if (in_doubles) CHECK(in_long_numbers);
    if (!in_doubles) continue;
    // The exact polynomial has one sign along both edges.
    for (const double edge : {-w, w}) {
      int positive = 0;
      for (int k = 0; k <= 8; ++k) {
        const Rational t(k, 8);
        const Rational u = from_double(u0) + t * (from_double(u1) - from_double(u0));
        const Rational v = from_double(v0) + t * (from_double(v1) - from_double(v0)) + from_double(edge);
        positive += f(u, v) > 0 ? 1 : 0;
      }
      CHECK((positive == 0 || positive == 9));
    }
  }
  CHECK(proved > 300);
  CHECK(only_long <= 2);
}

TEST_CASE("plane strips: along lines doubles enclose the exact coefficients", "[curve]") {
  const unsigned seed = 13;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0, 1);
  for (int i = 0; i < 60; ++i) {
    const int m = i % 7, n = i % 5;
    const BivariatePolynomial f = random_curve(generator, m, n);
    const std::size_t row = static_cast<std::size_t>(std::max(f.degree_s(), 0)) + 1;
    const double u = place(generator), v = place(generator), w = 1e-4 * place(generator);
    const double slope = std::ldexp(place(generator) - 0.5, 3 * i - 60);  // flat and steep
    const LineExpansion<DoubleBall> lines(enclosed_coefficients<DoubleBall>(f, 1), row, u, v, slope, w);
    for (const bool above : {false, true}) {
      const Polynomial x = Polynomial::variable();
      const Polynomial in_u = x + Polynomial(from_double(u));
      const Polynomial in_v =
          x * Polynomial(from_double(slope)) + Polynomial(from_double(v) + from_double(above ? w : -w));
      Polynomial exact;
      for (int k = f.degree_r(); k >= 0; --k) {
        Polynomial coefficient;
        for (int j = n; j >= 0; --j) coefficient = coefficient * in_v + Polynomial(f.coefficient(k, j));
        exact = exact * in_u + coefficient;
      }
      const std::vector<DoubleBall> found = lines.at(above);
      for (std::size_t k = 0; k < found.size(); ++k) {
        const RationalInterval ball = found[k].interval();
        const Rational c = exact.coefficient(static_cast<int>(k));
        CHECK((ball.lower <= c && c <= ball.upper));
        CHECK(found[k].radius() <= 1e-10 * std::pow(1 + std::fabs(slope), n));
      }
    }
  }
  // Beyond doubles nothing is proved.
  const BivariatePolynomial power = BivariatePolynomial::s() * BivariatePolynomial::s();
  const LineExpansion<DoubleBall> steep(enclosed_coefficients<DoubleBall>(power, 1), 3, 0.5, 0.5, 1e200,
                                        1e-3);
  CHECK(steep.at(true)[2].lower_magnitude() == 0);
}

TEST_CASE("plane strips: rounding does not hide a zero", "[curve]") {
  // (u - 1/3)^8 is below the errors of doubles about 1/3: they prove nothing, longer numbers do.
  BivariatePolynomial f = BivariatePolynomial::constant(power_of_two(-60));
  BivariatePolynomial power = BivariatePolynomial::constant(1);
  for (int k = 0; k < 8; ++k)
    power = power * (BivariatePolynomial::r() - BivariatePolynomial::constant(Rational(1, 3)));
  f += power;
  CHECK_FALSE(clear<DoubleBall>(f, 0.333, 0.5, 0.334, 0.5, 1e-5));
  CHECK(clear<ArbBall<256>>(f, 0.333, 0.5, 0.334, 0.5, 1e-5));
}

TEST_CASE("plane strips: the only zero in an interval, against exact roots", "[curve]") {
  const unsigned seed = 12;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0, 1);
  int found = 0, single = 0;
  for (int i = 0; i < 600; ++i) {
    const BivariatePolynomial f = random_curve(generator, 1 + i % 5, 1 + i % 8);
    const double u = place(generator), middle = place(generator), radius = 0.3 * place(generator);
    const auto v = PlaneStrip<DoubleBall>(f).only_zero(DoubleBall(u), DoubleBall(middle, radius));
    const Polynomial over = f.at_r(from_double(u));
    const auto roots = [&](double reach) {
      return real_roots(over, from_double(middle) - from_double(reach),
                        from_double(middle) + from_double(reach));
    };
    single += roots(1.1 * radius).size() == 1 && roots(radius).size() == 1 ? 1 : 0;
    if (!v) continue;
    ++found;
    const std::vector<RealAlgebraic> wide = roots(1.03 * radius);
    REQUIRE(wide.size() == 1);
    const RationalInterval root = wide[0].refined_to(power_of_two(-80)).interval(), ball = v->interval();
    CHECK(ball.lower < root.upper);
    CHECK(root.lower < ball.upper);
    CHECK(v->radius() < 1e-9);
  }
  CHECK(found > 50);
  CHECK(found > 0.7 * single);
}

TEST_CASE("plane strips: one of two zeros, told by the sign below it", "[curve]") {
  const unsigned seed = 14;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0, 1);
  const auto check = [](const auto& v, const RealAlgebraic& root) {
    const RationalInterval exact = root.refined_to(power_of_two(-120)).interval(), ball = v->interval();
    CHECK(ball.lower <= exact.upper);
    CHECK(exact.lower <= ball.upper);
  };
  int found = 0, pairs = 0;
  for (int i = 0; i < 2000; ++i) {
    const double u = place(generator), middle = place(generator), radius = 0.4 * place(generator);
    const BivariatePolynomial off =
        BivariatePolynomial::s() - BivariatePolynomial::constant(from_double(middle));
    const BivariatePolynomial f = random_curve(generator, 1 + i % 5, i % 7) +
                                  BivariatePolynomial::constant(1 << i % 13) *
                                      (off * off - BivariatePolynomial::constant(Rational(1, 40)));
    const Polynomial over = f.at_r(from_double(u));
    const auto roots = real_roots(over, from_double(middle) - from_double(radius),
                                  from_double(middle) + from_double(radius));
    if (roots.size() != 2) continue;
    ++pairs;
    const DoubleBall range(middle, radius);
    const DoubleDoubleBall long_range(middle, radius);
    CHECK_FALSE(PlaneStrip<DoubleBall>(f).only_zero(u, range));
    for (std::size_t k = 0; k < 2; ++k) {
      const int below = -over.derivative().sign_at(roots[k].refined_to(power_of_two(-200)).interval().lower);
      if (const auto v = PlaneStrip<DoubleBall>(f).only_zero(u, range, below)) ++found, check(v, roots[k]);
      const auto longer = PlaneStrip<DoubleDoubleBall>(f).only_zero(u, long_range, below, 0x1p-80);
      if (!longer) continue;
      check(longer, roots[k]);
      CHECK(longer->radius() < 0x1p-50);
    }
  }
  CHECK(pairs > 100);
  CHECK(found > pairs);
  // 2^-30 apart: (v - 1/2)^2 = 2^-62.
  const BivariatePolynomial off = BivariatePolynomial::s() - BivariatePolynomial::constant(Rational(1, 2)),
                            f = off * off - BivariatePolynomial::constant(power_of_two(-62));
  const PlaneStrip<DoubleDoubleBall> strip(f);
  const auto lower = strip.only_zero(0.25, DoubleDoubleBall(0.5, 0x1p-20), 1, 0x1p-80),
             upper = strip.only_zero(0.25, DoubleDoubleBall(0.5, 0x1p-20), -1, 0x1p-80);
  REQUIRE(lower);
  REQUIRE(upper);
  CHECK((*upper - *lower - DoubleDoubleBall(0x1p-30)).upper_magnitude() < 0x1p-70);
  // Two zeros that are one, and none, are never told.
  CHECK_FALSE(PlaneStrip<DoubleDoubleBall>(off * off).only_zero(0.25, DoubleDoubleBall(0.5, 0.25), 1));
  const BivariatePolynomial none = off * off + BivariatePolynomial::constant(power_of_two(-62));
  CHECK_FALSE(PlaneStrip<DoubleDoubleBall>(none).only_zero(0.25, DoubleDoubleBall(0.5, 0.25), 1));
}

TEST_CASE("plane strips: a zero that doubles enclose less narrowly", "[curve]") {
  // Of u + slope v - 1/3 - slope/2 doubles lose 2^-54, which moves the zero by 2^-54 / slope.
  const auto zero = [](const Rational& slope) {
    const BivariatePolynomial f = BivariatePolynomial::r() +
                                  BivariatePolynomial::constant(slope) * BivariatePolynomial::s() -
                                  BivariatePolynomial::constant(Rational(1, 3) + slope / 2);
    return PlaneStrip<DoubleBall>(f).only_zero(DoubleBall(1.0 / 3), DoubleBall(0.5, 0.25));
  };
  const auto near = zero(power_of_two(-19));
  REQUIRE(near);
  const double moved = to_double(Rational(1, 3) - from_double(1.0 / 3)) * 0x1p19;
  CHECK(std::fabs(near->approximation() - 0.5 - moved) <= near->radius() + 0x1p-52);
  CHECK(near->radius() < 0x1p-25);
  CHECK_FALSE(zero(power_of_two(-32)));
}

}  // namespace exsect::plane_strip_test
