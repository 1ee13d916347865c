#include <exsect/algebra/rational.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::rational_test {

namespace {

/// The defining property: no double is nearer, and of two equally near ones the mantissa is even.
void check_nearest(const Rational& q) {
  const double x = to_double(q);
  INFO("q = " << q << ", x = " << x);
  REQUIRE(std::isfinite(x));
  const Rational error = abs(q - from_double(x));
  for (const double y : {std::nextafter(x, INFINITY), std::nextafter(x, -INFINITY)}) {
    if (!std::isfinite(y)) continue;
    const Rational other = abs(q - from_double(y));
    CHECK(error <= other);
    if (error == other) {
      int exponent = 0;
      const double ulp = std::max(std::abs(x - y), std::numeric_limits<double>::denorm_min());
      CHECK(std::fmod(std::frexp(x, &exponent) == 0.5 ? 0.0 : x / ulp, 2.0) == 0.0);
    }
  }
}

/// Tries all denominators in turn.
Rational simplest_by_search(const Rational& a, const Rational& b) {
  for (Integer d = 1;; ++d) {
    // The smallest n with n/d > a.
    Integer n = numerator(a) * d / denominator(a) - 2;
    while (Rational(n, d) <= a) ++n;
    if (Rational(n, d) < b) return Rational(n, d);
  }
}

}  // namespace

TEST_CASE("to_double rounds to nearest, ties to even") {
  CHECK(to_double(0) == 0.0);
  CHECK(to_double(Rational(1, 3)) == 1.0 / 3.0);
  CHECK(to_double(Rational(-1, 10)) == -0.1);
  const Rational tie = 1 + power_of_two(-53);
  CHECK(to_double(tie) == 1.0);
  CHECK(to_double(1 + 3 * power_of_two(-53)) == 1.0 + std::ldexp(1.0, -51));
  CHECK(to_double(tie + power_of_two(-2000)) == std::nextafter(1.0, 2.0));
  CHECK(to_double(tie - power_of_two(-2000)) == 1.0);
  CHECK(to_double(2 - power_of_two(-54)) == 2.0);
}

TEST_CASE("to_double at the ends of the range") {
  const double smallest = std::numeric_limits<double>::denorm_min();
  CHECK(to_double(power_of_two(-1074)) == smallest);
  CHECK(to_double(power_of_two(-1075)) == 0.0);
  CHECK(to_double(power_of_two(-1075) + power_of_two(-3000)) == smallest);
  CHECK(to_double(-3 * power_of_two(-1075)) == -2 * smallest);
  CHECK(to_double(power_of_two(-5000)) == 0.0);
  CHECK(to_double(power_of_two(1023)) == std::ldexp(1.0, 1023));
  CHECK(to_double(power_of_two(1024) - power_of_two(970)) == std::numeric_limits<double>::infinity());
  CHECK(to_double(power_of_two(1024) - power_of_two(970) - 1) == std::numeric_limits<double>::max());
  CHECK(to_double(-power_of_two(5000)) == -std::numeric_limits<double>::infinity());
}

TEST_CASE("to_double on random rationals and back") {
  const std::uint64_t seed = 20240301;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 500; ++i) {
    Integer denominator = random.big_integer(random.integer(1, 200));
    if (denominator == 0) denominator = 1;
    const Rational q = Rational(random.big_integer(random.integer(1, 200)), denominator) *
                       power_of_two(i % 3 == 0 ? -1070 : 0);
    check_nearest(q);
    const double x = to_double(q);
    CHECK(to_double(from_double(x)) == x);
  }
}

TEST_CASE("to_double on long numerators over powers of two") {
  for (const int bits : {64, 65, 66, 127, 128, 129, 192, 300}) {
    INFO(bits << " bits");
    const Rational leading = power_of_two(bits - 1);
    const Rational half = power_of_two(bits - 54);  // of the last place of the double
    for (const long exponent : {0L, -40L, -900L - bits, 900L - bits})
      for (const Rational& below : {Rational(0), Rational(1), Rational(-1), power_of_two(5)}) {
        // A tie upwards, one downwards, and both but for the last bits.
        check_nearest((leading + half + below) * power_of_two(exponent));
        check_nearest((-leading - 3 * half - below) * power_of_two(exponent));
        check_nearest((2 * leading - half + below) * power_of_two(exponent));
      }
  }
  test::Random random(20240304);
  for (int i = 0; i < 500; ++i) {
    const Integer numerator = 2 * random.big_integer(random.integer(60, 200)) + 1;
    check_nearest(numerator * power_of_two(random.integer(-900, 700)));
  }
}

TEST_CASE("from_double is exact and refuses what is not finite") {
  CHECK(from_double(0.5) == Rational(1, 2));
  CHECK(from_double(-0.0) == 0);
  CHECK(from_double(0.1) == Rational(Integer("3602879701896397"), Integer("36028797018963968")));
  CHECK(from_double(std::numeric_limits<double>::denorm_min()) == power_of_two(-1074));
  CHECK_THROWS_AS(from_double(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  CHECK_THROWS_AS(from_double(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST_CASE("simplest_between") {
  CHECK(simplest_between(0, 1) == Rational(1, 2));
  CHECK(simplest_between(-1, 1) == 0);
  CHECK(simplest_between(1, 2) == Rational(3, 2));
  CHECK(simplest_between(1, 3) == 2);
  CHECK(simplest_between(-2, 0) == -1);
  CHECK(simplest_between(Rational(1, 3), Rational(1, 2)) == Rational(2, 5));
  CHECK(simplest_between(0, Rational(1, 5)) == Rational(1, 6));
  CHECK(simplest_between(Rational(314, 100), Rational(315, 100)) == Rational(22, 7));
  CHECK_THROWS_AS(simplest_between(1, 1), std::invalid_argument);
  CHECK_THROWS_AS(simplest_between(2, 1), std::invalid_argument);
}

TEST_CASE("simplest_between has the least denominator") {
  const std::uint64_t seed = 20240302;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 300; ++i) {
    const Rational a = random.rational(60, 30);
    const Rational b = a + Rational(random.integer(1, 20), random.integer(1, 400));
    INFO("(" << a << ", " << b << ")");
    const Rational q = simplest_between(a, b);
    CHECK(a < q);
    CHECK(q < b);
    CHECK(denominator(q) == denominator(simplest_by_search(a, b)));
  }
}

TEST_CASE("power_of_two and interval helpers") {
  CHECK(power_of_two(0) == 1);
  CHECK(power_of_two(-3) == Rational(1, 8));
  CHECK(power_of_two(70) == Rational(Integer(1) << 70));
  const RationalInterval interval{Rational(1, 3), Rational(2, 3)};
  CHECK(interval.width() == Rational(1, 3));
  CHECK(interval.midpoint() == Rational(1, 2));
  CHECK(sign(Rational(-2, 7)) == -1);
}

TEST_CASE("rational root: of powers and of no others") {
  CHECK(rational_root(0, 2) == Rational(0));
  CHECK(rational_root(Rational(4, 9), 2) == Rational(2, 3));
  CHECK(rational_root(Rational(-8, 27), 3) == Rational(-2, 3));
  CHECK(rational_root(Rational(-5, 7), 1) == Rational(-5, 7));
  CHECK_FALSE(rational_root(Rational(-4, 9), 2));
  CHECK_FALSE(rational_root(Rational(4, 27), 3));
  CHECK_FALSE(rational_root(2, 2));
  for (int k = 1; k < 40; ++k) {
    const Rational r(k * k - 600, 7 * k + 1);
    CHECK(rational_root(r * r, 2) == Rational(abs(r)));
    CHECK(rational_root(r * r * r, 3) == r);
    CHECK_FALSE(rational_root(r * r + power_of_two(-300), 2));
  }
}

}  // namespace exsect::rational_test
