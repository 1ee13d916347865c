#include <exsect/algebra/quadratic_sign.h>

#include <stdexcept>

#include "algebra/algebraic_specimens.h"
#include "support/catch.h"

namespace exsect::quadratic_sign_test {
using namespace exsect::test;

TEST_CASE("quadratic sign: each combination of signs, and exact cancellation") {
  CHECK(quadratic_sign(0, 0, 0) == 0);
  CHECK(quadratic_sign(0, 0, 5) == 0);
  CHECK(quadratic_sign(0, 5, 0) == 0);
  CHECK(quadratic_sign(-1, 5, 0) == -1);
  CHECK(quadratic_sign(0, -2, 3) == -1);
  CHECK(quadratic_sign(2, 0, 3) == 1);
  CHECK(quadratic_sign(1, 1, 3) == 1);
  CHECK(quadratic_sign(-1, -1, 3) == -1);
  CHECK(quadratic_sign(-3, 2, Rational(9, 4)) == 0);
  CHECK(quadratic_sign(3, -2, Rational(9, 4)) == 0);
  CHECK(quadratic_sign(-3, 2, 2) == -1);
  CHECK(quadratic_sign(-3, 2, 3) == 1);
  CHECK(quadratic_sign(3, -2, 2) == 1);
  CHECK(quadratic_sign(3, -2, 3) == -1);
  const Rational tiny = power_of_two(-5000);
  CHECK(quadratic_sign(-3, 2, Rational(9, 4) + tiny) == 1);
  CHECK(quadratic_sign(-3, 2, Rational(9, 4) - tiny) == -1);
  CHECK_THROWS_AS(quadratic_sign(1, 1, -1), std::domain_error);
}

TEST_CASE("quadratic sign: polynomials at a real algebraic number") {
  const RealAlgebraic s = QuadraticNumber{0, 1, 2}.number(linear_factor(7));
  const Polynomial t = Polynomial::variable();
  // s - 2 sqrt(s^2/4) = 0, 4 - 2 sqrt(2 s^2) = 0, (s - 3) + (1 + s) sqrt(1 + 2 - s^2) = 2 s - 2 > 0
  CHECK(quadratic_sign(t, -2, t * t * Rational(1, 4), s) == 0);
  CHECK(quadratic_sign(4, -2, t * t * Polynomial(2), s) == 0);
  CHECK(quadratic_sign(t - Polynomial(3), t + Polynomial(1), Polynomial(3) - t * t, s) == 1);
  CHECK(quadratic_sign(-5, 7, t * t - Polynomial(2), s) == -1);
  CHECK(quadratic_sign(t * t - Polynomial(2), -7, t, s) == -1);
  CHECK_THROWS_AS(quadratic_sign(1, 1, -t, s), std::domain_error);
}

TEST_CASE("quadratic sign: random, against the sum of two roots") {
  const std::uint64_t seed = 20250701;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 300; ++i) {
    const Rational alpha = random.rational(9, 4), beta = random.rational(9, 4),
                   d = abs(random.rational(9, 4));
    CHECK(quadratic_sign(alpha, beta, d) == sign_of_sum(alpha, beta, d, 0, 0));
  }
}

TEST_CASE("quadratic sign: random polynomials at quadratic numbers, against nested squaring") {
  const std::uint64_t seed = 20250702;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    const QuadraticNumber x{random.rational(3, 3), random.rational(3, 3), random.integer(2, 3)};
    if (x.b == 0) continue;
    const Polynomial alpha = random.polynomial(2, 5), beta = random.polynomial(2, 5),
                     root = random.polynomial(1, 5);
    // D = root^2: the number is alpha + beta |root| at x.
    const QuadraticNumber r = value_at(root, x);
    const int root_sign = sign_of_sum(r.a, r.b, r.c, 0, 0);
    const QuadraticNumber expected = value_at(alpha + Polynomial(root_sign) * beta * root, x);
    CHECK(quadratic_sign(alpha, beta, root * root, x.number()) ==
          sign_of_sum(expected.a, expected.b, expected.c, 0, 0));
  }
}

}  // namespace exsect::quadratic_sign_test
