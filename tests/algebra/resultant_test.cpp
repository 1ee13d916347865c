#include <exsect/algebra/resultant.h>

#include <stdexcept>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::resultant_test {
using test::with_roots;

namespace {

Rational power(const Rational& base, int exponent) {
  Rational result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

/// Determinant by Gaussian elimination over Q.
Rational determinant(std::vector<std::vector<Rational>> m) {
  Rational result = 1;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::size_t pivot = k;
    while (pivot < m.size() && m[pivot][k] == 0) ++pivot;
    if (pivot == m.size()) return 0;
    if (pivot != k) {
      std::swap(m[pivot], m[k]);
      result = -result;
    }
    result *= m[k][k];
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      const Rational factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < m.size(); ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return result;
}

/// The determinant of the Sylvester matrix, coefficients of f in the first deg g rows, leading first.
Rational sylvester(const Polynomial& f, const Polynomial& g) {
  const int m = f.degree();
  const int n = g.degree();
  std::vector<std::vector<Rational>> matrix;
  for (int row = 0; row < m + n; ++row) {
    std::vector<Rational> entries;
    for (int column = 0; column < m + n; ++column)
      entries.push_back(row < n ? f.coefficient(m - (column - row))
                                : g.coefficient(n - (column - (row - n))));
    matrix.push_back(entries);
  }
  return determinant(matrix);
}

/// The chain by the subresultant structure theorem: pseudo-remainder sequence over Q with its scale factors.
/// For deg f >= deg g: S_{d-1} of the next remainder and the defective subresultants between follow from the
/// last two members; signs as in the determinant definition.
std::vector<Polynomial> chain_by_remainders(const Polynomial& f, const Polynomial& g) {
  const int m = f.degree();
  const int n = g.degree();
  if (m < n) {
    // Exchanging the blocks of n-j and m-j rows.
    std::vector<Polynomial> result = chain_by_remainders(g, f);
    for (int j = 0; j < static_cast<int>(result.size()); ++j)
      if ((m - j) * (n - j) % 2 != 0)
        result[static_cast<std::size_t>(j)] = -result[static_cast<std::size_t>(j)];
    return result;
  }
  // S_j(f,g) = (-1)^((m-j)(n-j)) lc(g)^(m-e) S_j(g, rem(f,g)), e = deg rem, for j < e; at j = e the multiple
  // (-1)^((m-e)(n-e)) lc(g)^(m-e) lc(rem)^(n-e-1) rem; 0 for e < j < n-1; and S_{n-1} = (-1)^(m-n+1)
  // lc(g)^(m-n+1) rem.
  std::vector<Polynomial> result(static_cast<std::size_t>(n));
  const Polynomial remainder = divide(f, g).remainder;
  const Rational lead = g.leading_coefficient();
  const int e = remainder.degree();
  if (e < 0) return result;
  const auto sign_of = [](int exponent) { return exponent % 2 == 0 ? 1 : -1; };
  if (e >= 1) {
    const std::vector<Polynomial> tail = chain_by_remainders(g, remainder);
    for (int j = 0; j < e; ++j)
      result[static_cast<std::size_t>(j)] =
          tail[static_cast<std::size_t>(j)] * Polynomial(sign_of((m - j) * (n - j)) * power(lead, m - e));
  }
  result[static_cast<std::size_t>(e)] =
      remainder * Polynomial(sign_of((m - e) * (n - e)) * power(lead, m - e) *
                             power(remainder.leading_coefficient(), n - e - 1));
  result[static_cast<std::size_t>(n - 1)] =
      remainder * Polynomial(sign_of(m - n + 1) * power(lead, m - n + 1));
  return result;
}

BivariatePolynomial random_bivariate(test::Random& random, int degree_r, int degree_s,
                                     int max_denominator = 1) {
  std::vector<Polynomial> coefficients;
  for (int i = 0; i <= degree_r; ++i) coefficients.push_back(random.polynomial(degree_s, 9, max_denominator));
  return BivariatePolynomial(std::move(coefficients));
}

}  // namespace

TEST_CASE("resultant: constants and zero") {
  const Polynomial f({3, -1, Rational(2, 5)});
  CHECK(resultant(Polynomial(3), f) == 9);
  CHECK(resultant(f, Polynomial(Rational(-1, 2))) == Rational(1, 4));
  CHECK(resultant(Polynomial(3), Polynomial(5)) == 1);
  CHECK(resultant(Polynomial(), f) == 0);
  CHECK(resultant(f, Polynomial()) == 0);
  CHECK(resultant(Polynomial(), Polynomial()) == 0);
}

TEST_CASE("resultant: product over known roots, determinant") {
  const std::uint64_t seed = 20240361;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 40; ++i) {
    std::vector<Rational> roots;
    for (int k = random.integer(1, 5); k > 0; --k) roots.push_back(random.rational(9, 5));
    const Rational lead = random.rational(9, 4) + Rational(1, 9);
    const Polynomial f = with_roots(roots) * Polynomial(lead);
    const Polynomial g = random.polynomial(random.integer(1, 6), 9, 5) + Polynomial({0, Rational(1, 7)});
    Rational product = power(lead, g.degree());
    for (const Rational& root : roots) product *= g(root);
    CHECK(resultant(f, g) == product);
    CHECK(resultant(f, g) == sylvester(f, g));
    CHECK(resultant(g, f) == sylvester(g, f));
  }
  CHECK(resultant(with_roots({1, 2, 3}), with_roots({3, 5})) == 0);
}

TEST_CASE("resultant in r and in s: by specialisation") {
  const std::uint64_t seed = 20240362;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 20; ++i) {
    const BivariatePolynomial f = random_bivariate(random, random.integer(1, 3), 2, 3);
    const BivariatePolynomial g = random_bivariate(random, random.integer(1, 4), 3);
    if (f.degree_r() < 0 || g.degree_r() < 0) continue;
    const Polynomial in_s = resultant_r(f, g);
    const Polynomial in_r = resultant_s(f, g);
    for (int k = 1; k < 6; ++k) {
      const Rational value(3 * k + 1, k);
      if (f.at_s(value).degree() == f.degree_r() && g.at_s(value).degree() == g.degree_r())
        CHECK(in_s(value) == resultant(f.at_s(value), g.at_s(value)));
      if (f.at_r(value).degree() == f.degree_s() && g.at_r(value).degree() == g.degree_s())
        CHECK(in_r(value) == resultant(f.at_r(value), g.at_r(value)));
    }
  }
}

TEST_CASE("resultant in r: constants in r, zero, common factors") {
  const BivariatePolynomial r = BivariatePolynomial::r();
  const BivariatePolynomial s = BivariatePolynomial::s();
  const BivariatePolynomial three = BivariatePolynomial::constant(3);
  CHECK(resultant_r(s, r * r + s) == Polynomial({0, 0, 1}));
  CHECK(resultant_r(r * r * r + s, s + three) == Polynomial({27, 27, 9, 1}));
  CHECK(resultant_r(s, s + three) == Polynomial(1));
  CHECK(resultant_r(BivariatePolynomial(), r).is_zero());
  CHECK(resultant_r(r, BivariatePolynomial()).is_zero());
  CHECK(resultant_r((r - s) * (r + three), (r - s) * (r * r + s)).is_zero());
  CHECK(resultant_r(r - s, r * r * r + s) == Polynomial({0, 1, 0, 1}));
  CHECK(resultant_r(r * r * r + s, r - s) == Polynomial({0, -1, 0, -1}));
}

TEST_CASE("discriminant") {
  const BivariatePolynomial r = BivariatePolynomial::r();
  const BivariatePolynomial s = BivariatePolynomial::s();
  const BivariatePolynomial three = BivariatePolynomial::constant(3);
  // b^2 - 4ac and -4p^3 - 27q^2.
  CHECK(discriminant_r(s * r * r + three * r + s * s) == Polynomial({9, 0, 0, -4}));
  CHECK(discriminant_r(r * r * r + s * r + three) == Polynomial({-243, 0, 0, -4}));
  CHECK(discriminant_r(s * r + three) == Polynomial(1));
  CHECK(discriminant_r((r - s) * (r - s)).is_zero());
  // lc^2 times the squared difference of the roots, product over all pairs.
  CHECK(discriminant_r(three * (r - s) * (r + s) * (r - three)) ==
        Polynomial(81) * Polynomial({0, 0, 4}) * Polynomial({-3, 1}) * Polynomial({-3, 1}) *
            Polynomial({3, 1}) * Polynomial({3, 1}));
  CHECK_THROWS_AS(discriminant_r(s), std::domain_error);
  CHECK_THROWS_AS(discriminant_r(BivariatePolynomial()), std::domain_error);
}

TEST_CASE("subresultants: determinants against remainders") {
  const std::uint64_t seed = 20240363;
  INFO("seed " << seed);
  test::Random random(seed);
  CHECK_THROWS_AS(subresultants(Polynomial(3), Polynomial({1, 1})), std::domain_error);
  CHECK_THROWS_AS(subresultants(Polynomial({1, 1}), Polynomial()), std::domain_error);
  for (int i = 0; i < 60; ++i) {
    // Every third pair has a common factor, every fourth a gap in the degrees of the remainders.
    const Polynomial common = i % 3 == 0 ? random.polynomial(random.integer(1, 3), 5) : Polynomial(1);
    Polynomial g = random.polynomial(random.integer(1, 5), 7, 1 + i % 4) * common;
    Polynomial f = random.polynomial(random.integer(1, 6), 7) * common;
    if (i % 4 == 0) f = g * Polynomial({1, 2, 1}) + random.polynomial(1, 7) * common;
    if (f.degree() < 1 || g.degree() < 1) continue;
    INFO("case " << i << " degrees " << f.degree() << " and " << g.degree());
    const std::vector<Polynomial> chain = subresultants(f, g);
    REQUIRE(chain.size() == static_cast<std::size_t>(std::min(f.degree(), g.degree())));
    CHECK(chain == chain_by_remainders(f, g));
    CHECK(subresultants(g, f) == chain_by_remainders(g, f));
    CHECK(chain[0] == Polynomial(resultant(f, g)));
    // The first that does not vanish is the gcd.
    const int d = gcd(f, g).degree();
    for (int j = 0; j < d && j < static_cast<int>(chain.size()); ++j)
      CHECK(chain[static_cast<std::size_t>(j)].is_zero());
    if (d < static_cast<int>(chain.size()))
      CHECK(gcd(chain[static_cast<std::size_t>(d)], Polynomial()) == gcd(f, g));
  }
}

TEST_CASE("subresultants in r: by specialisation") {
  const std::uint64_t seed = 20240364;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 10; ++i) {
    const BivariatePolynomial f = random_bivariate(random, 2, 2, 3) + BivariatePolynomial::r();
    const BivariatePolynomial g = random_bivariate(random, random.integer(1, 4), 4);
    if (f.degree_r() < 1 || g.degree_r() < 1) continue;
    const std::vector<BivariatePolynomial> chain = subresultants_r(f, g);
    CHECK(chain[0].coefficient(0) == resultant_r(f, g));
    for (int j = 0; j < static_cast<int>(chain.size()); ++j)
      for (int k = 0; k <= j; ++k)
        CHECK(subresultant_coefficient_r(f, g, j, k) == chain[static_cast<std::size_t>(j)].coefficient(k));
    CHECK_THROWS_AS(subresultant_coefficient_r(f, g, 0, 1), std::domain_error);
    CHECK_THROWS_AS(subresultant_coefficient_r(f, g, static_cast<int>(chain.size()), 0), std::domain_error);
    for (int k = 1; k < 4; ++k) {
      const Rational s(5 * k + 2, 3);
      if (f.at_s(s).degree() != f.degree_r() || g.at_s(s).degree() != g.degree_r()) continue;
      const std::vector<Polynomial> specialised = subresultants(f.at_s(s), g.at_s(s));
      REQUIRE(specialised.size() == chain.size());
      for (std::size_t j = 0; j < chain.size(); ++j) CHECK(chain[j].at_s(s) == specialised[j]);
    }
  }
}

namespace {

/// Polynomials in s as coefficients of the powers of r, some of them zero, the highest not.
BivariatePolynomial of_degrees(test::Random& random, int degree, int degree_s, int bits) {
  std::vector<Polynomial> rows;
  for (int i = 0; i <= degree; ++i) {
    const bool empty = i > 0 && i < degree && random.integer(0, 4) == 0;
    rows.push_back(empty ? Polynomial() : random.big_polynomial(degree_s, bits));
  }
  if (rows.back().is_zero()) rows.back() = 1;
  return BivariatePolynomial(rows);
}

/// At more values of s than the resultant has zeros.
void check_by_values(const BivariatePolynomial& f, const BivariatePolynomial& g, int degree) {
  const Polynomial result = resultant_r(f, g);
  CHECK(result.degree() <= degree);
  int known = 0;
  for (int s = -2; known <= degree; ++s) {
    const Polynomial a = f.at_s(Rational(s, 3)), b = g.at_s(Rational(s, 3));
    if (a.degree() != f.degree_r() || b.degree() != g.degree_r()) continue;
    REQUIRE(result(Rational(s, 3)) == resultant(a, b));
    ++known;
  }
}

}  // namespace

TEST_CASE("resultant in r: high degrees, from its values") {
  const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
  const BivariatePolynomial f =
      r * r * r * r * r * Polynomial(Rational(1, 6)) - s;  // sparse, with a denominator
  const BivariatePolynomial g = r * r * r * r * s - BivariatePolynomial::constant(Rational(-2, 7));
  check_by_values(f, g, 9);
  CHECK(resultant_r(f * g, f * (g + s)).is_zero());
  CHECK(resultant_r(g, f) == resultant_r(f, g));  // the product of the degrees is even
  const std::uint64_t seed = 20240811;
  INFO("seed " << seed);
  test::Random random(seed);
  for (const int bits : {1, 3, 53, 200, 1100})
    for (int i = 0; i < 4; ++i) {
      const int m = random.integer(4, 7), n = random.integer(4, 7), p = random.integer(0, 5),
                q = random.integer(0, 5);
      INFO("bits " << bits << ", degrees " << m << " " << n << ", in s " << p << " " << q);
      const Polynomial scale(Rational(1 + random.integer(0, 9), 1 + random.integer(0, 99)));
      check_by_values(of_degrees(random, m, p, bits) * scale, of_degrees(random, n, q, bits), m * q + n * p);
    }
}

}  // namespace exsect::resultant_test
