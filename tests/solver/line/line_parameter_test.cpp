#include <exsect/algebra/algebraic_value.h>
#include <exsect/solver/line_parameter.h>

#include <random>

#include "support/catch.h"

namespace exsect::line_parameter_test {
namespace {

const BivariatePolynomial r = BivariatePolynomial::r();
const BivariatePolynomial s = BivariatePolynomial::s();

BivariatePolynomial constant(const Rational& c) { return BivariatePolynomial::constant(c); }

/// r^2 = s, s^2 = 2 in the positive quadrant of a box.
TriangularPoint fourth_root_of_two() {
  const RealAlgebraic root = real_roots(Polynomial{-2, 0, 1}, 1, 2).front();
  return {root, r * r - s, {1, 2}};
}

TEST_CASE("a quotient at a point is the same parameter as its number") {
  const unsigned seed = 5;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> number(-4, 4);
  const TriangularPoint p = fourth_root_of_two();
  for (int i = 0; i < 30; ++i) {
    const auto polynomial = [&] {
      return constant(number(random)) + r * Polynomial(number(random)) + s * Polynomial(number(random)) +
             r * s * Polynomial(number(random));
    };
    const BivariatePolynomial n = polynomial(), d = polynomial();
    if (sign_at(d, p) == 0) {
      CHECK_THROWS_AS(LineParameter(n, d, p), std::invalid_argument);
      continue;
    }
    const LineParameter quotient(n, d, p);
    const auto exact = quotient_at(n, d, p);
    REQUIRE(exact);
    CHECK(quotient.number() == exact);
    const LineParameter known(*exact);
    CHECK(known.number() == exact);
    for (const Rational& value : {Rational(0), Rational(1), Rational(-3, 7), Rational(i, 5)}) {
      CHECK(quotient.compare(value) == exact->compare(value));
      CHECK(known.compare(value) == exact->compare(value));
    }
    for (const Rational& width : {Rational(3), power_of_two(-10), power_of_two(-200)})
      for (const LineParameter& t : {quotient, known}) {
        const RationalInterval enclosed = t.enclosure(width);
        CHECK(enclosed.width() <= width);
        CHECK(exact->compare(enclosed.lower) >= 0);
        CHECK(exact->compare(enclosed.upper) <= 0);
      }
  }
}

TEST_CASE("a quotient at a point: exact at 0 and at 1, and near them") {
  const TriangularPoint p = fourth_root_of_two();
  const Rational tiny = power_of_two(-300);
  const BivariatePolynomial zero = r * r - s;
  for (const Rational& end : {Rational(0), Rational(1)})
    for (const Rational& denominator : {Rational(3), Rational(-3)}) {
      const auto at = [&](const Rational& shift) {
        return LineParameter(zero + constant(denominator * (end + shift)), constant(denominator), p);
      };
      CHECK(at(0).compare(end) == 0);
      CHECK(at(Rational(3, 1000)).enclosure(1).width() == 0);  // known to be rational
      CHECK(at(tiny).compare(end) == 1);
      CHECK(at(-tiny).compare(end) == -1);
      CHECK(at(0).number() == RealAlgebraic(end));
    }
}

}  // namespace
}  // namespace exsect::line_parameter_test
