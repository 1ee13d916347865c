#include <exsect/algebra/ball.h>
#include <exsect/algebra/bivariate_value.h>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::bivariate_value_test {

namespace {

BivariatePolynomial random_bivariate(test::Random& random) {
  std::vector<Polynomial> coefficients;
  for (int i = random.integer(0, 4); i >= 0; --i)
    coefficients.push_back(random.polynomial(random.integer(0, 3), 9, 4));
  return BivariatePolynomial(std::move(coefficients));
}

}  // namespace

TEST_CASE("value in a ring: curves substituted into a polynomial") {
  const std::uint64_t seed = 61;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const BivariatePolynomial f = random_bivariate(random);
    const Polynomial r = random.polynomial(2, 5), s = random.polynomial(3, 5);
    const Polynomial along = value_in(f, r, s, [](const Rational& c) { return Polynomial(c); });
    const Rational t = random.rational(9, 7);
    CHECK(along(t) == f(r(t), s(t)));
  }
  CHECK(value_in(BivariatePolynomial(), Polynomial(2), Polynomial(3), [](const Rational& c) {
          return Polynomial(c);
        }).is_zero());
}

TEST_CASE("value in a ring: balls enclose the values of their points") {
  using Ball = ArbBall<256>;
  const std::uint64_t seed = 62;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const BivariatePolynomial f = random_bivariate(random);
    const Rational r = random.rational(9, 7), s = random.rational(9, 7);
    const RationalInterval value = value_in(f, Ball::enclosing(r), Ball::enclosing(s), [](const Rational& c) {
                                     return Ball::enclosing(c);
                                   }).interval();
    const Rational exact = f(r, s);
    CHECK(value.lower <= exact);
    CHECK(exact <= value.upper);
    CHECK(value.upper - value.lower < Rational(1, 1000000000));
  }
}

}  // namespace exsect::bivariate_value_test
