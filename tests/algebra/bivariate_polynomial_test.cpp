#include <exsect/algebra/bivariate_polynomial.h>

#include <stdexcept>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::bivariate_polynomial_test {

namespace {

BivariatePolynomial random_bivariate(test::Random& random, int degree_r, int degree_s,
                                     int max_denominator = 1) {
  std::vector<Polynomial> coefficients;
  for (int i = 0; i <= degree_r; ++i) coefficients.push_back(random.polynomial(degree_s, 9, max_denominator));
  return BivariatePolynomial(std::move(coefficients));
}

}  // namespace

TEST_CASE("bivariate: zero, degrees, coefficients") {
  const BivariatePolynomial zero;
  CHECK(zero.is_zero());
  CHECK(zero.degree_r() == -1);
  CHECK(zero.degree_s() == -1);
  CHECK(zero.total_degree() == -1);
  CHECK(zero(1, 2) == 0);
  CHECK(zero.exchanged() == zero);
  CHECK(BivariatePolynomial::constant(0) == zero);
  const BivariatePolynomial r = BivariatePolynomial::r();
  const BivariatePolynomial s = BivariatePolynomial::s();
  const BivariatePolynomial f = r * r * s - s * s * s * s + BivariatePolynomial::constant(Rational(1, 2));
  CHECK(f.degree_r() == 2);
  CHECK(f.degree_s() == 4);
  CHECK(f.total_degree() == 4);
  CHECK(f.coefficient(2, 1) == 1);
  CHECK(f.coefficient(0, 4) == -1);
  CHECK(f.coefficient(5).is_zero());
  CHECK(f(2, 3) == Rational(12 - 81) + Rational(1, 2));
  CHECK((f - f).is_zero());
  CHECK((r * r - r * r + s).degree_r() == 0);
}

TEST_CASE("bivariate: arithmetic against evaluation") {
  const std::uint64_t seed = 20240321;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const BivariatePolynomial f = random_bivariate(random, random.integer(0, 3), random.integer(0, 3), 4);
    const BivariatePolynomial g = random_bivariate(random, random.integer(0, 3), random.integer(0, 3));
    const Polynomial in_s = random.polynomial(2, 5);
    const Rational r = random.rational(9, 9);
    const Rational s = random.rational(9, 9);
    CHECK((f + g)(r, s) == f(r, s) + g(r, s));
    CHECK((f - g)(r, s) == f(r, s) - g(r, s));
    CHECK((f * g)(r, s) == f(r, s) * g(r, s));
    CHECK((f * in_s)(r, s) == f(r, s) * in_s(s));
    CHECK(f.at_s(s)(r) == f(r, s));
    CHECK(f.at_r(r)(s) == f(r, s));
    CHECK(f.exchanged()(s, r) == f(r, s));
    CHECK(f.exchanged().exchanged() == f);
    CHECK(f.derivative_r().at_s(s) == f.at_s(s).derivative());
    CHECK(f.derivative_s().at_r(r) == f.at_r(r).derivative());
    if (!g.is_zero()) CHECK(exact_quotient(f * g, g) == f);
  }
}

TEST_CASE("bivariate: multiplication by one of its own coefficients") {
  BivariatePolynomial f(std::vector<Polynomial>{Polynomial({1, 1}), Polynomial({2, 3})});
  const BivariatePolynomial expected(std::vector<Polynomial>{Polynomial({1, 1}) * Polynomial({1, 1}),
                                                             Polynomial({2, 3}) * Polynomial({1, 1})});
  f *= f.coefficient(0);
  CHECK(f == expected);
}

TEST_CASE("bivariate: exact quotient refuses") {
  const BivariatePolynomial r = BivariatePolynomial::r();
  const BivariatePolynomial s = BivariatePolynomial::s();
  CHECK_THROWS_AS(exact_quotient(r * s, r + s), std::domain_error);
  CHECK_THROWS_AS(exact_quotient(r, BivariatePolynomial()), std::domain_error);
  CHECK(exact_quotient(BivariatePolynomial(), r).is_zero());
}

TEST_CASE("bivariate: gcd") {
  const BivariatePolynomial r = BivariatePolynomial::r();
  const BivariatePolynomial s = BivariatePolynomial::s();
  const BivariatePolynomial two = BivariatePolynomial::constant(2);
  const BivariatePolynomial half = BivariatePolynomial::constant(Rational(1, 2));
  CHECK(gcd(BivariatePolynomial(), BivariatePolynomial()).is_zero());
  CHECK(gcd(BivariatePolynomial(), half * s - r) == two * r - s);
  CHECK(gcd(two, r * s) == BivariatePolynomial::constant(1));
  // The content in s belongs to it.
  CHECK(gcd(half * s * (r + s), s * s * r) == s);

  const std::uint64_t seed = 20240322;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 20; ++i) {
    const BivariatePolynomial common = random_bivariate(random, 2, 2) + r * r * r;
    const BivariatePolynomial a = random_bivariate(random, 2, 2, 3) + r * r * r;
    const BivariatePolynomial b = random_bivariate(random, 2, 1, 3) + r * r * r * s;
    const BivariatePolynomial g = gcd(common * a, common * b);
    // g is a common divisor that common divides, and nothing remains (at one s, hence everywhere).
    CHECK(exact_quotient(common * a, g) * g == common * a);
    const BivariatePolynomial rest = exact_quotient(g, common);
    CHECK(exact_quotient(common * b, g) * g == common * b);
    if (gcd(a, b).degree_r() == 0) CHECK(rest.degree_r() == 0);
    CHECK(sign(g.coefficient(g.degree_r()).leading_coefficient()) == 1);
  }
}

}  // namespace exsect::bivariate_polynomial_test
