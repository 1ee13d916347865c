#include <exsect/algebra/bivariate_factors.h>

#include <stdexcept>

#include "support/catch.h"

namespace exsect::bivariate_factors_test {
namespace {

const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }

/// The factors multiplied again, up to a rational constant.
bool divides_into(const BivariatePolynomial& f) {
  BivariatePolynomial rest = f;
  for (const BivariatePower& power : irreducible_factors(f))
    for (int i = 0; i < power.multiplicity; ++i) rest = exact_quotient(rest, power.factor);
  return rest.total_degree() == 0;
}

}  // namespace

TEST_CASE("irreducible factors: constants, powers, and what is irreducible over Q alone") {
  CHECK_THROWS_AS(irreducible_factors(BivariatePolynomial()), std::domain_error);
  CHECK(irreducible_factors(number(Rational(-3, 7))).empty());
  const BivariatePolynomial conjugate = r * r - number(2) * s * s;
  REQUIRE(irreducible_factors(conjugate).size() == 1);
  CHECK(irreducible_factors(conjugate)[0].multiplicity == 1);
  CHECK(irreducible_factors(r * r - number(4) * s * s).size() == 2);
}

TEST_CASE("irreducible factors: their powers multiply to the polynomial") {
  const BivariatePolynomial circle = r * r + s * s - number(Rational(1, 3));
  const BivariatePolynomial line = number(Rational(2, 5)) * r - s + number(7);
  const BivariatePolynomial f = number(Rational(-5, 9)) * circle * line * line * s * s * s;
  const std::vector<BivariatePower> factors = irreducible_factors(f);
  REQUIRE(factors.size() == 3);
  CHECK(divides_into(f));
  int sum = 0;
  for (const BivariatePower& power : factors) sum += power.multiplicity;
  CHECK(sum == 6);
}

}  // namespace exsect::bivariate_factors_test
