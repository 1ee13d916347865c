#include <exsect/algebra/fixed_point_interval.h>

#include <stdexcept>

#include "random_numbers.h"
#include "support/catch.h"

namespace exsect::fixed_point_interval_test {

namespace {

bool contains(const FixedPointInterval& a, const Rational& q) {
  return a.interval().lower <= q && q <= a.interval().upper;
}

FixedPointInterval around(const Rational& q, long bits) { return {RationalInterval{q, q}, bits}; }

}  // namespace

TEST_CASE("fixed point: ends, signs and exact values") {
  const FixedPointInterval a(RationalInterval{Rational(-1, 3), Rational(1, 2)}, 4);
  CHECK(a.interval().lower == Rational(-6, 16));
  CHECK(a.interval().upper == Rational(1, 2));
  CHECK(a.contains_zero());
  CHECK(FixedPointInterval(Integer(-5), 7).interval().width() == 0);
  CHECK_THROWS_AS(FixedPointInterval(Integer(1), 4) / a, std::domain_error);
  CHECK_THROWS_AS(sqrt(FixedPointInterval(Integer(-1), 4)), std::domain_error);
  CHECK(sqrt(FixedPointInterval(Integer(9), 4)).interval().upper == 3);
  CHECK(sqrt(a).interval().lower == 0);
}

TEST_CASE("fixed point: operations enclose the exact results, nearly tight") {
  const unsigned seed = 31;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 300; ++i) {
    const long bits = 5 + i % 90;
    const Rational p = random.rational(50, 40);
    const Rational q = random.rational(50, 40);
    const auto a = around(p, bits);
    const auto b = around(q, bits);
    CHECK(contains(a + b, p + q));
    CHECK(contains(a - b, p - q));
    CHECK(contains(a * b, p * q));
    CHECK((a * b).interval().width() <= 110 * power_of_two(-bits));
    CHECK(contains(-a, -p));
    if (!b.contains_zero()) {
      CHECK(contains(a / b, p / q));
      CHECK(contains(-a / b, -p / q));
    }
    CHECK(contains(sqrt(a * a), abs(p)));
    const auto wide = FixedPointInterval(RationalInterval{-1, Rational(2, 3)}, bits) * a;
    CHECK(contains(wide, -p));
    CHECK(contains(wide, p * Rational(2, 3)));
  }
}

TEST_CASE("fixed point: polynomials over boxes") {
  const unsigned seed = 32;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const Polynomial f = random.polynomial(6, 30, 9);
    const Rational t = random.rational(9, 9);
    const IntegerPolynomial g(f);
    CHECK(contains(enclose_numerator(g, around(t, 30)), f(t) * Rational(g.denominator)));
    const BivariatePolynomial h(
        std::vector<Polynomial>{f, random.polynomial(2, 5, 7), random.polynomial(3, 5, 7)});
    const Rational r = random.rational(9, 9);
    CHECK(contains(enclose(h, around(r, 30), around(t, 30)), h(r, t)));
  }
  CHECK(IntegerPolynomial(Polynomial()).numerators.empty());
}

TEST_CASE("fixed point: rounding outward to short dyadics") {
  CHECK(bits_below(1) == 0);
  CHECK(bits_below(Rational(3, 4)) == 1);
  CHECK(bits_below(Rational(1, 2)) == 1);
  CHECK(bits_below(Rational(1, 3)) == 2);
  CHECK(bits_below(5) == 0);
  CHECK(bits_below(power_of_two(-50)) == 50);
  CHECK_THROWS_AS(bits_below(0), std::invalid_argument);
  const RationalInterval x = {Rational(1, 3), Rational(1, 3) + Rational(1, 2000)};
  const RationalInterval rounded = rounded_outward(x, Rational(1, 1000));
  CHECK(rounded.lower <= x.lower);
  CHECK(rounded.upper >= x.upper);
  CHECK(rounded.width() <= Rational(1, 1000));
  CHECK(4096 % denominator(rounded.lower) == 0);
}

}  // namespace exsect::fixed_point_interval_test
