// Arithmetic in number fields: against products, and against the field of a real root.
#include <exsect/algebra/number_field.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/triangular_point.h>

#include <random>

#include "support/catch.h"

namespace exsect::number_field_test {
namespace {

const Polynomial kCubic({-2, 1, 0, 1});  // s³ + s - 2 ... with a root 1: not irreducible
const Polynomial kField({-2, 0, 0, 1});  // s³ - 2

Polynomial random_element(std::mt19937_64& generator) {
  const auto digit = [&] { return Rational(static_cast<int>(generator() % 41) - 20) / 7; };
  return Polynomial({digit(), digit(), digit()});
}

BivariatePolynomial random_polynomial(std::mt19937_64& generator, int degree) {
  std::vector<Polynomial> coefficients;
  for (int i = 0; i < degree; ++i) coefficients.push_back(random_element(generator));
  coefficients.push_back(Polynomial({1, 1}));
  return BivariatePolynomial(coefficients);
}

}  // namespace

TEST_CASE("inverses in a number field") {
  const auto root = inverse_modulo(Polynomial({0, 1}), kField);  // 1/s = s²/2
  REQUIRE(root);
  CHECK(*root == Polynomial({0, 0, Rational(1, 2)}));
  CHECK_FALSE(inverse_modulo(Polynomial({-2, 0, 0, 1}), kField));
  CHECK_FALSE(inverse_modulo(Polynomial({-1, 1}), kCubic));
  CHECK(inverse_modulo(Polynomial({5}), kField) == Polynomial(Rational(1, 5)));
  CHECK_THROWS_AS(inverse_modulo(Polynomial({0, 1}), Polynomial(3)), std::domain_error);
  std::mt19937_64 generator(3);
  for (int i = 0; i < 20; ++i) {
    const Polynomial a = random_element(generator) + Polynomial({0, 0, 0, 1});  // not reduced
    const auto b = inverse_modulo(a, kField);
    REQUIRE(b);
    CHECK(divide(a * *b, kField).remainder == Polynomial(1));
  }
}

TEST_CASE("greatest common divisors over a number field") {
  const RealAlgebraic cube_root = real_roots(kField, 0, 2).front();
  std::mt19937_64 generator(4);
  for (const int degree : {0, 1, 2}) {
    const BivariatePolynomial common = random_polynomial(generator, degree);
    const BivariatePolynomial f = common * random_polynomial(generator, 2);
    const BivariatePolynomial h = common * random_polynomial(generator, 3);
    const auto found = gcd_modulo(f, h, kField);
    REQUIRE(found);
    CHECK(found->degree_r() == degree);
    CHECK(found->coefficient(degree) == Polynomial(1));
    CHECK(gcd_degree_bound(f, h, kField) == degree);
    // the same over the field of the real root, by signs of subresultants
    CHECK(gcd_at(f, h, cube_root).degree_r() == degree);
    CHECK(gcd_at(*found, common, cube_root).degree_r() == degree);
  }
  const BivariatePolynomial r = BivariatePolynomial::r();
  CHECK(gcd_modulo(BivariatePolynomial(), BivariatePolynomial(), kField) == BivariatePolynomial());
  CHECK(gcd_modulo(r * r, BivariatePolynomial(), kField) == r * r);
  CHECK(gcd_modulo(BivariatePolynomial(), BivariatePolynomial::constant(2) * r, kField) == r);
  // (s - 1) r is not zero modulo s³ + s - 2, but has no inverse leading coefficient.
  CHECK_FALSE(gcd_modulo(r * BivariatePolynomial({Polynomial({-1, 1})}), r + BivariatePolynomial::constant(1),
                         kCubic));
}

TEST_CASE("degrees of common divisors modulo a prime") {
  const BivariatePolynomial r = BivariatePolynomial::r();
  const BivariatePolynomial s = BivariatePolynomial::s();
  const BivariatePolynomial one = BivariatePolynomial::constant(1);
  CHECK_FALSE(gcd_degree_bound(BivariatePolynomial(), BivariatePolynomial(), kField));
  CHECK(gcd_degree_bound(r * r, BivariatePolynomial(), kField) == 2);
  CHECK(gcd_degree_bound(BivariatePolynomial(), one, kField) == 0);
  // r - s and r³ - 2 have a common root over the field only.
  CHECK(gcd_degree_bound(r - s, r * r * r - BivariatePolynomial::constant(2), kField) == 1);
  CHECK(gcd_degree_bound(r - s, r * r * r - BivariatePolynomial::constant(3), kField) == 0);
  // Both leading coefficients are zero in the field.
  const BivariatePolynomial zero({kField});
  CHECK_FALSE(gcd_degree_bound(zero * r + one, zero * r + one, kField));
  CHECK_THROWS_AS(gcd_degree_bound(r, r, Polynomial(3)), std::domain_error);
}

}  // namespace exsect::number_field_test
