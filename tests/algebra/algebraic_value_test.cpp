#include <exsect/algebra/algebraic_value.h>

#include "random_numbers.h"
#include "support/catch.h"

namespace exsect::algebraic_value_test {

namespace {

const BivariatePolynomial r = BivariatePolynomial::r();
const BivariatePolynomial s = BivariatePolynomial::s();

BivariatePolynomial constant(const Rational& c) { return BivariatePolynomial::constant(c); }

/// sqrt 2 as the s of a point.
RealAlgebraic root_of_two() {
  const Polynomial t = Polynomial::variable();
  return real_roots(t * t - Polynomial(2), 0, 2).front();
}

}  // namespace

TEST_CASE("values at a rational point are rational") {
  const TriangularPoint p(RealAlgebraic(Rational(1, 2)), r - constant(Rational(1, 3)),
                          {Rational(1, 3), Rational(1, 3)});
  const RealAlgebraic value = value_at(r * s + s, p);
  REQUIRE(value.is_rational());
  CHECK(value.rational() == Rational(2, 3));
  CHECK(value_at(constant(7), p) == RealAlgebraic(7));
  CHECK(value_at(BivariatePolynomial(), p) == RealAlgebraic(0));
}

TEST_CASE("values at irrational points") {
  // r = sqrt(3), s = sqrt(2)
  const TriangularPoint p = roots_at(r * r - constant(3), root_of_two(), 0, 2).front();
  const RealAlgebraic product = value_at(r * s, p);
  CHECK(sign_at(Polynomial::variable() * Polynomial::variable() - Polynomial(6), product) == 0);
  CHECK(product.compare(0) > 0);
  const RealAlgebraic square = value_at(r * r * s * s, p);
  REQUIRE(square.is_rational());
  CHECK(square.rational() == 6);
  CHECK(value_at(r - r, p) == RealAlgebraic(0));
  INFO("r = s = sqrt 2, which has a conjugate point");
  const TriangularPoint q = roots_at(r - s, root_of_two(), 0, 2).front();
  CHECK(value_at(r * s, q) == RealAlgebraic(2));
  CHECK(value_at(r + s, q) > RealAlgebraic(2));
}

TEST_CASE("values where the degree of the resultant in s drops at an integer") {
  // s = 1/sqrt 2 with the minimal polynomial 2 s^2 - 1, g = r^2 - s r - s, h = -r: Res_r(g, h - T) = T^2 + (T
  // - 1) s.
  const Polynomial t = Polynomial::variable();
  const RealAlgebraic root = real_roots(Polynomial(2) * t * t - Polynomial(1), 0, 1).front();
  const TriangularPoint p = roots_at(r * r - s * r - s, root, 0, 2).front();
  const RealAlgebraic value = value_at(constant(0) - r, p);
  const RationalInterval near = enclosure_at(r, p, power_of_two(-60));
  CHECK(value.compare(-near.upper) >= 0);
  CHECK(value.compare(-near.lower) <= 0);
  // Eliminating s = r^2/(r + 1) from 2 s^2 = 1.
  CHECK(sign_at(Polynomial(2) * t * t * t * t - (t - Polynomial(1)) * (t - Polynomial(1)), value) == 0);
}

TEST_CASE("a quotient is found where h - T w drops in degree at an integer T") {
  // r = 1/sqrt 2, not monic: (r + 1) / (r + 2) is a root of 7 t^2 - 6 t + 1.
  const TriangularPoint p = roots_at(constant(2) * r * r - constant(1), RealAlgebraic(1), 0, 2).front();
  const auto value = quotient_at(r + constant(1), r + constant(2), p);
  REQUIRE(value);
  CHECK(sign_at(Polynomial{1, -6, 7}, *value) == 0);
  CHECK(value->compare(Rational(1, 2)) > 0);
}

TEST_CASE("enclosures have the width asked for and agree with the exact value") {
  const TriangularPoint p = roots_at(r * r * s - constant(1), root_of_two(), 0, 2).front();
  const unsigned seed = 77;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 12; ++i) {
    BivariatePolynomial h(std::vector<Polynomial>{random.polynomial(2, 9, 5), random.polynomial(2, 9, 5)});
    const RationalInterval near = enclosure_at(h, p, power_of_two(-70));
    CHECK(near.width() <= power_of_two(-70));
    const RealAlgebraic value = value_at(h, p);
    CHECK(value.compare(near.lower) >= 0);
    CHECK(value.compare(near.upper) <= 0);
    CHECK(sign_at(h, p) == value.compare(0));
  }
}

}  // namespace exsect::algebraic_value_test
