#include <exsect/algebra/polynomial.h>

#include <stdexcept>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::polynomial_test {

namespace {

Rational evaluate_by_powers(const Polynomial& f, const Rational& t) {
  Rational sum = 0;
  Rational power = 1;
  for (const Rational& c : f.coefficients()) {
    sum += c * power;
    power *= t;
  }
  return sum;
}

/// gcd by Euclid's algorithm on coefficients alone.
Polynomial gcd_by_euclid(Polynomial a, Polynomial b) {
  while (!b.is_zero()) {
    Polynomial remainder = divide(a, b).remainder;
    a = b;
    b = remainder;
  }
  return a.is_zero() ? a : a * Polynomial(1 / a.leading_coefficient());
}

}  // namespace

TEST_CASE("polynomial: zero, constants, coefficients") {
  const Polynomial zero;
  CHECK(zero.degree() == -1);
  CHECK(zero.is_zero());
  CHECK(zero.leading_coefficient() == 0);
  CHECK(zero.coefficients().empty());
  CHECK(zero.sign_at(3) == 0);
  CHECK(zero(Rational(1, 2)) == 0);
  CHECK(Polynomial(std::vector<Rational>{}) == zero);
  CHECK(Polynomial({0, 0, 0}) == zero);
  CHECK(zero.primitive() == zero);
  CHECK(Polynomial(7).degree() == 0);
  CHECK(Polynomial(Rational(-2, 3)).sign_at(Rational(5, 7)) == -1);
  const Polynomial f({Rational(1, 2), Rational(-1, 3), 0, Rational(5, 6), 0});
  CHECK(f.degree() == 3);
  CHECK(f.coefficient(0) == Rational(1, 2));
  CHECK(f.coefficient(1) == Rational(-1, 3));
  CHECK(f.coefficient(2) == 0);
  CHECK(f.coefficient(3) == Rational(5, 6));
  CHECK(f.coefficient(9) == 0);
  CHECK(f.coefficient(-1) == 0);
  CHECK(f.primitive() == Polynomial({3, -2, 0, 5}));
  CHECK((-f).primitive() == -Polynomial({3, -2, 0, 5}));
}

TEST_CASE("polynomial: copies and moves are independent values") {
  Polynomial f({1, 2, 3});
  Polynomial g = f;
  g += Polynomial(1);
  CHECK(f == Polynomial({1, 2, 3}));
  Polynomial h = std::move(g);
  CHECK(h == Polynomial({2, 2, 3}));
  g = f;
  CHECK(g == f);
  f = f * f;
  CHECK(g == Polynomial({1, 2, 3}));
  f = *&f;
  CHECK(f == g * g);
  f -= f;
  CHECK(f.is_zero());
}

TEST_CASE("polynomial: arithmetic against evaluation") {
  const std::uint64_t seed = 20240311;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const Polynomial f = random.polynomial(random.integer(0, 8), 20, 1 + i % 9);
    const Polynomial g = random.polynomial(random.integer(0, 8), 20, 1 + i % 7);
    const Rational t = random.rational(30, 20);
    CHECK((f + g)(t) == f(t) + g(t));
    CHECK((f - g)(t) == f(t) - g(t));
    CHECK((f * g)(t) == f(t) * g(t));
    CHECK((-f)(t) == -f(t));
    CHECK(f.compose(g)(t) == f(g(t)));
    CHECK(f(t) == evaluate_by_powers(f, t));
    CHECK(f.sign_at(t) == sign(f(t)));
    CHECK((f * g).derivative() == f.derivative() * g + f * g.derivative());
    const int n = f.degree() + i % 3;
    if (t != 0 && n >= 0) {
      Rational power = 1;
      for (int k = 0; k < n; ++k) power *= t;
      CHECK(f.reversed(n)(t) == power * f(1 / t));
    }
    Polynomial sum = f;
    sum += g;
    CHECK(sum == f + g);
    sum *= sum;
    CHECK(sum == (f + g) * (f + g));
  }
  CHECK_THROWS_AS(Polynomial({1, 2, 3}).reversed(1), std::invalid_argument);
}

TEST_CASE("polynomial: sign_at near and at roots") {
  const std::uint64_t seed = 20240312;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 40; ++i) {
    const Rational root = i % 2 == 0 ? random.integer(-999, 999) * power_of_two(-random.integer(0, 90))
                                     : random.rational(1000, 500);
    const Polynomial f = test::linear_factor(root) * random.big_polynomial(random.integer(0, 20), 200);
    const Rational near = root + power_of_two(-i * 10);
    INFO("root " << root);
    CHECK(f.sign_at(root) == 0);
    CHECK(f.sign_at(near) == sign(evaluate_by_powers(f, near)));
  }
}

TEST_CASE("polynomial: sign_at at long arguments, balls and exact") {
  const std::uint64_t seed = 20240316;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 12; ++i) {
    Integer denominator = abs(random.big_integer(150)) + 1;
    if (i % 2 == 0) denominator = Integer(1) << 150;
    const Rational root(random.big_integer(150), denominator);
    const Polynomial f = test::linear_factor(root) * random.big_polynomial(60, 500);
    CHECK(f.sign_at(root) == 0);
    for (const long distance : {10L, 130L, 600L, 3000L}) {
      const Rational near = root + power_of_two(-distance);
      CHECK(f.sign_at(near) == sign(evaluate_by_powers(f, near)));
      CHECK((-f).sign_at(near) == -f.sign_at(near));
    }
  }
}

TEST_CASE("polynomial: division") {
  const std::uint64_t seed = 20240313;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const Polynomial a = random.polynomial(random.integer(0, 9), 20, 5);
    const Polynomial b = random.polynomial(random.integer(0, 5), 20, 5) + Polynomial(Rational(1, 77));
    const Division division = divide(a, b);
    CHECK(division.quotient * b + division.remainder == a);
    CHECK(division.remainder.degree() < b.degree());
    CHECK(exact_quotient(a * b, b) == a);
  }
  CHECK_THROWS_AS(divide(Polynomial(1), Polynomial()), std::domain_error);
  CHECK_THROWS_AS(exact_quotient(Polynomial({1, 1}), Polynomial({2, 1})), std::domain_error);
  CHECK_THROWS_AS(exact_quotient(Polynomial({1, 1}), Polynomial()), std::domain_error);
}

TEST_CASE("polynomial: gcd") {
  CHECK(gcd(Polynomial(), Polynomial()).is_zero());
  CHECK(gcd(Polynomial(), Polynomial({2, 4})) == Polynomial({Rational(1, 2), 1}));
  CHECK(gcd(Polynomial(6), Polynomial({2, 4})) == Polynomial(1));
  const std::uint64_t seed = 20240314;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const Polynomial common = random.polynomial(random.integer(0, 4), 9, 3);
    const Polynomial a = common * random.polynomial(random.integer(0, 4), 9, 3);
    const Polynomial b = common * random.polynomial(random.integer(0, 4), 9, 3);
    CHECK(gcd(a, b) == gcd_by_euclid(a, b));
  }
}

TEST_CASE("polynomial: squarefree part and factors") {
  const Polynomial t = Polynomial::variable();
  const Polynomial a = t - Polynomial(Rational(1, 3));
  const Polynomial b = t * t + Polynomial(2);
  const Polynomial c = Polynomial(5) * t + Polynomial(1);
  const Polynomial f = Polynomial(Rational(-3, 7)) * a * a * b * c * c * c;

  CHECK_FALSE(is_squarefree(f));
  CHECK(is_squarefree(a * b * c));
  CHECK(is_squarefree(Polynomial(Rational(2, 3))));
  CHECK(is_squarefree(c));
  CHECK_FALSE(is_squarefree(t * t));
  CHECK_THROWS_AS(is_squarefree(Polynomial()), std::domain_error);

  CHECK(squarefree_part(f) == -(a * b * c).primitive());
  CHECK(squarefree_part(Polynomial(Rational(-4, 9))) == Polynomial(-1));
  CHECK(squarefree_part(Polynomial({2, -4})) == Polynomial({1, -2}));
  CHECK_THROWS_AS(squarefree_part(Polynomial()), std::domain_error);

  const std::vector<PolynomialPower> factors = squarefree_factors(f);
  REQUIRE(factors.size() == 3);
  CHECK(factors[0].multiplicity == 1);
  CHECK(factors[0].factor == b);
  CHECK(factors[1].multiplicity == 2);
  CHECK(factors[1].factor == a.primitive());
  CHECK(factors[2].multiplicity == 3);
  CHECK(factors[2].factor == c);
  CHECK_THROWS_AS(squarefree_factors(Polynomial()), std::domain_error);
  CHECK(squarefree_factors(Polynomial(3)).empty());

  CHECK(irreducible_factors(f).size() == 3);
  CHECK(irreducible_factors(t * t - Polynomial(1)).size() == 2);
  CHECK_THROWS_AS(irreducible_factors(Polynomial()), std::domain_error);
}

TEST_CASE("polynomial: squarefree test does not trust a prime that divides the leading coefficient") {
  // Modulo 2^63 - 25 the first is constant, the second drops its leading term.
  const Rational p = power_of_two(63) - 25;
  CHECK(is_squarefree(Polynomial({1, p})));
  CHECK(is_squarefree(Polynomial({1, 0, p})));
  CHECK_FALSE(is_squarefree(Polynomial({1, 2 * p, p * p})));
  // Modulo that prime t^2 - p is a square, over Q it is squarefree.
  CHECK(is_squarefree(Polynomial({-p, 0, 1})));
  CHECK(squarefree_part(Polynomial({-p, 0, 1})) == Polynomial({-p, 0, 1}));
}

TEST_CASE("polynomial: factors multiply back") {
  const std::uint64_t seed = 20240315;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 30; ++i) {
    const Polynomial a = random.polynomial(random.integer(1, 3), 9) + Polynomial::variable();
    const Polynomial f = a * a * random.polynomial(random.integer(1, 4), 9) * random.polynomial(2, 9, 4);
    if (f.is_zero()) continue;
    for (const auto& factors : {squarefree_factors(f), irreducible_factors(f)}) {
      Polynomial product = 1;
      for (const PolynomialPower& power : factors) {
        CHECK(power.factor.degree() > 0);
        CHECK(is_squarefree(power.factor));
        for (int k = 0; k < power.multiplicity; ++k) product *= power.factor;
      }
      CHECK(product * Polynomial(f.leading_coefficient() / product.leading_coefficient()) == f);
    }
    const Polynomial part = squarefree_part(f);
    CHECK(part.primitive() == part);
    CHECK(is_squarefree(part));
    CHECK(divide(f, part).remainder.is_zero());
    CHECK(sign(part.leading_coefficient()) == sign(f.leading_coefficient()));
  }
}

}  // namespace exsect::polynomial_test
