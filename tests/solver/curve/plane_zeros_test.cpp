// Zeros of a plane curve over a number: in doubles and in sums of two, against exact ones.
#include "curve/plane_zeros.h"

#include <exsect/algebra/double_double_ball.h>
#include <exsect/algebra/real_algebraic.h>

#include <random>

#include "solver/curve/random_curve.h"
#include "support/catch.h"

namespace exsect::plane_zeros_test {

using random_curve::random_curve;

TEST_CASE("plane zeros: the only zero in an interval, against exact roots", "[curve]") {
  const unsigned seed = 12;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0, 1);
  int found = 0, single = 0;
  for (int i = 0; i < 600; ++i) {
    const BivariatePolynomial f = random_curve(generator, 1 + i % 5, 1 + i % 8);
    const double u = place(generator), middle = place(generator), radius = 0.3 * place(generator);
    const auto v = PlaneZeros<DoubleBall>(f).only_zero(DoubleBall(u), DoubleBall(middle, radius));
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

TEST_CASE("plane zeros: one of two zeros, told by the sign below it", "[curve]") {
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
    CHECK_FALSE(PlaneZeros<DoubleBall>(f).only_zero(u, range));
    for (std::size_t k = 0; k < 2; ++k) {
      const int below = -over.derivative().sign_at(roots[k].refined_to(power_of_two(-200)).interval().lower);
      if (const auto v = PlaneZeros<DoubleBall>(f).only_zero(u, range, below)) ++found, check(v, roots[k]);
      const auto longer = PlaneZeros<DoubleDoubleBall>(f).only_zero(u, long_range, below, 0x1p-80);
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
  const PlaneZeros<DoubleDoubleBall> strip(f);
  const auto lower = strip.only_zero(0.25, DoubleDoubleBall(0.5, 0x1p-20), 1, 0x1p-80),
             upper = strip.only_zero(0.25, DoubleDoubleBall(0.5, 0x1p-20), -1, 0x1p-80);
  REQUIRE(lower);
  REQUIRE(upper);
  CHECK((*upper - *lower - DoubleDoubleBall(0x1p-30)).upper_magnitude() < 0x1p-70);
  // Two zeros that are one, and none, are never told.
  CHECK_FALSE(PlaneZeros<DoubleDoubleBall>(off * off).only_zero(0.25, DoubleDoubleBall(0.5, 0.25), 1));
  const BivariatePolynomial none = off * off + BivariatePolynomial::constant(power_of_two(-62));
  CHECK_FALSE(PlaneZeros<DoubleDoubleBall>(none).only_zero(0.25, DoubleDoubleBall(0.5, 0.25), 1));
}

TEST_CASE("plane zeros: a zero that doubles enclose less narrowly", "[curve]") {
  // Of u + slope v - 1/3 - slope/2 doubles lose 2^-54, which moves the zero by 2^-54 / slope.
  const auto zero = [](const Rational& slope) {
    const BivariatePolynomial f = BivariatePolynomial::r() +
                                  BivariatePolynomial::constant(slope) * BivariatePolynomial::s() -
                                  BivariatePolynomial::constant(Rational(1, 3) + slope / 2);
    return PlaneZeros<DoubleBall>(f).only_zero(DoubleBall(1.0 / 3), DoubleBall(0.5, 0.25));
  };
  const auto near = zero(power_of_two(-19));
  REQUIRE(near);
  const double moved = to_double(Rational(1, 3) - from_double(1.0 / 3)) * 0x1p19;
  CHECK(std::fabs(near->approximation() - 0.5 - moved) <= near->radius() + 0x1p-52);
  CHECK(near->radius() < 0x1p-25);
  CHECK_FALSE(zero(power_of_two(-32)));
}

}  // namespace exsect::plane_zeros_test
