#include <exsect/algebra/bernstein.h>

#include <stdexcept>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::bernstein_test {

namespace {

/// sum b_i binom(n,i) t^i (1-t)^(n-i) as a polynomial, from products.
Polynomial expand(const std::vector<Rational>& b) {
  const Polynomial t = Polynomial::variable();
  const int n = static_cast<int>(b.size()) - 1;
  Polynomial sum;
  for (int i = 0; i <= n; ++i) {
    Polynomial term(b[static_cast<std::size_t>(i)] * binomial(n, i));
    for (int k = 0; k < i; ++k) term *= t;
    for (int k = i; k < n; ++k) term *= Polynomial(1) - t;
    sum += term;
  }
  return sum;
}

/// f(a + t(b-a)).
Polynomial on_unit_interval(const Polynomial& f, const Rational& a, const Rational& b) {
  return f.compose(Polynomial({a, b - a}));
}

}  // namespace

TEST_CASE("binomial") {
  CHECK(binomial(0, 0) == 1);
  CHECK(binomial(4, 2) == 6);
  CHECK(binomial(4, 5) == 0);
  CHECK(binomial(4, -1) == 0);
  CHECK(binomial(-1, 0) == 0);
  for (int n = 1; n < 140; n += 23)
    for (int k = 0; k <= n; ++k) CHECK(binomial(n, k) == binomial(n - 1, k - 1) + binomial(n - 1, k));
}

TEST_CASE("bernstein coefficients of simple polynomials") {
  CHECK(bernstein_coefficients(Polynomial(), 2) == std::vector<Rational>{0, 0, 0});
  CHECK(bernstein_coefficients(Polynomial(5), 0) == std::vector<Rational>{5});
  CHECK(bernstein_coefficients(Polynomial(5), 2) == std::vector<Rational>{5, 5, 5});
  CHECK(bernstein_coefficients(Polynomial::variable(), 2) == std::vector<Rational>{0, Rational(1, 2), 1});
  CHECK(bernstein_coefficients(Polynomial::variable(), 1, -3, 7) == std::vector<Rational>{-3, 7});
  CHECK_THROWS_AS(bernstein_coefficients(Polynomial({1, 2, 3}), 1), std::invalid_argument);
  CHECK_THROWS_AS(bernstein_coefficients(Polynomial(1), 1, 2, 2), std::invalid_argument);
  CHECK_THROWS_AS(bernstein_coefficients(Polynomial(), -2), std::invalid_argument);
  CHECK(from_bernstein({}).is_zero());
  CHECK(from_bernstein({Rational(2, 3)}) == Polynomial(Rational(2, 3)));
}

TEST_CASE("bernstein coefficients against expansion, and back") {
  const std::uint64_t seed = 20240331;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 60; ++i) {
    const Polynomial f = random.polynomial(random.integer(0, 9), 30, 1 + i % 8);
    const int n = std::max(f.degree(), 0) + random.integer(0, 4);
    const Rational a = random.rational(9, 6);
    const Rational b = a + Rational(random.integer(1, 20), random.integer(1, 9));
    const std::vector<Rational> c = bernstein_coefficients(f, n, a, b);
    CHECK(expand(c) == on_unit_interval(f, a, b));
    CHECK(from_bernstein(c) == on_unit_interval(f, a, b));
    CHECK(bernstein_coefficients(f, n) == bernstein_coefficients(f, n, 0, 1));
    CHECK(c.front() == f(a));
    CHECK(c.back() == f(b));
  }
}

TEST_CASE("de Casteljau halves are the coefficients on the parts") {
  const std::uint64_t seed = 20240332;
  INFO("seed " << seed);
  test::Random random(seed);
  CHECK(split_bernstein({}, Rational(1, 2)).left.empty());
  for (int i = 0; i < 60; ++i) {
    const int n = random.integer(0, 9);
    const Polynomial f = random.polynomial(n, 30, 1 + i % 8);
    const Rational t(random.integer(1, 11), 12);
    const BernsteinHalves halves = split_bernstein(bernstein_coefficients(f, n), t);
    CHECK(halves.left == bernstein_coefficients(f, n, 0, t));
    CHECK(halves.right == bernstein_coefficients(f, n, t, 1));
  }
}

TEST_CASE("de Casteljau at the ends and outside") {
  const std::vector<Rational> b{1, Rational(-2, 3), 5};
  CHECK(split_bernstein(b, 0).right == b);
  CHECK(split_bernstein(b, 0).left == std::vector<Rational>{1, 1, 1});
  CHECK(split_bernstein(b, 1).left == b);
  CHECK(from_bernstein(split_bernstein(b, 3).left) == from_bernstein(b).compose(Polynomial({0, 3})));
}

TEST_CASE("sign variations skip zeros") {
  CHECK(sign_variations({}) == 0);
  CHECK(sign_variations({0, 0}) == 0);
  CHECK(sign_variations({0, 1, 0, 2}) == 0);
  CHECK(sign_variations({1, 0, -2, 0, 0, 3, -1}) == 3);
  CHECK(sign_variations({-1, 0, 1}) == 1);
}

}  // namespace exsect::bernstein_test
