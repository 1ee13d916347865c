// Products of known factors.
#include "lift/common_factor.h"

#include <random>
#include <stdexcept>

#include "support/catch.h"

namespace exsect::common_factor_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                      z = SpacePolynomial::variable(2), one = SpacePolynomial::constant(1);

SpacePolynomial random_polynomial(std::mt19937& random, int degree) {
  SpacePolynomial::Terms terms;
  for (const Exponents& e : exponents_up_to(degree))
    terms[e] = Rational(std::uniform_int_distribution<int>(-4, 4)(random)) / 3;
  terms[{0, 0, degree}] = 1;  // not constant
  return SpacePolynomial(terms);
}

}  // namespace

TEST_CASE("common factor: of products") {
  const SpacePolynomial ball = x * x + y * y + z * z - one, plane = x - Rational(2, 3) * z, other = y + one;
  CHECK(common_factor(ball * plane, Rational(7) * ball * other) == ball.primitive());
  CHECK(common_factor(ball * ball, ball * other) == ball.primitive());
  CHECK(common_factor(ball, plane) == one);
  CHECK(common_factor(plane * other, Rational(-3) * plane) == plane.primitive());
  CHECK(common_factor(z, z * z) == z);
  const unsigned seed = 17;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 20; ++round) {
    const SpacePolynomial f = random_polynomial(random, 2), g = random_polynomial(random, 1),
                          h = random_polynomial(random, 2);
    // Another common factor of f and h would be divided out as well.
    const SpacePolynomial common = common_factor(f * g, h * g);
    CHECK(exact_quotient(common, g) * g == common);
    CHECK(exact_quotient(f * g, common) * common == f * g);
    CHECK(common_factor(exact_quotient(f * g, common), exact_quotient(h * g, common)) == one);
    CHECK(exact_quotient(f * g, g) == f);
  }
}

TEST_CASE("common factor: quotients that are none, and multiple factors") {
  CHECK_THROWS_AS(exact_quotient(x * y + one, x), std::domain_error);
  CHECK(exact_quotient(SpacePolynomial(), x).is_zero());
  const SpacePolynomial ball = x * x + y * y + z * z - one;
  CHECK(squarefree_part(ball * ball).primitive() == ball.primitive());
  CHECK(squarefree_part(Rational(2) * x * x * y * y).primitive() == x * y);
  CHECK(squarefree_part(x * x * x * (y - z)).primitive() == (x * (y - z)).primitive());
  CHECK(squarefree_part(ball * x) == ball * x);
  CHECK(squarefree_part(Rational(5) * one) == Rational(5) * one);
}

}  // namespace exsect::common_factor_test
