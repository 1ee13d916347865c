#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/trivariate_gcd.h>

#include <random>

#include "support/catch.h"

namespace exsect::trivariate_gcd_test {
namespace {

TrivariateCoefficients product(const TrivariateCoefficients& a, const TrivariateCoefficients& b) {
  TrivariateCoefficients result;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a[i].size(); ++j)
      for (std::size_t k = 0; k < b.size(); ++k)
        for (std::size_t l = 0; l < b[k].size(); ++l) {
          if (result.size() <= i + k) result.resize(i + k + 1);
          if (result[i + k].size() <= j + l) result[i + k].resize(j + l + 1);
          result[i + k][j + l] += a[i][j] * b[k][l];
        }
  return result;
}

/// The polynomial in (r,s) at this u.
BivariatePolynomial at(const TrivariateCoefficients& f, const Rational& u) {
  std::vector<Polynomial> rows;
  for (const auto& row : f) {
    std::vector<Rational> in_s;
    for (const Polynomial& c : row) in_s.push_back(c(u));
    rows.emplace_back(in_s);
  }
  return BivariatePolynomial(std::move(rows));
}

TrivariateCoefficients random_form(std::mt19937_64& generator, std::size_t r, std::size_t s, int u) {
  std::uniform_int_distribution<int> digit(-3, 3);
  TrivariateCoefficients f(r + 1, std::vector<Polynomial>(s + 1));
  for (auto& row : f)
    for (Polynomial& c : row) {
      std::vector<Rational> coefficients;
      for (int k = 0; k <= u; ++k) coefficients.emplace_back(digit(generator));
      c = Polynomial(coefficients);
    }
  f[r][s] += Polynomial(7);  // the degrees are true
  return f;
}

TEST_CASE("awkward trivariate common divisors") {
  const Polynomial u = Polynomial::variable();
  CHECK(gcd(TrivariateCoefficients{}, TrivariateCoefficients{}).empty());
  // gcd(0, 2 u r) = u r, gcd(u r, u s) = u, gcd(r - u, s) = 1.
  const TrivariateCoefficients ur = {{}, {u}};
  CHECK(at(gcd({}, {{}, {u * Polynomial(2)}}), 3) == at(ur, 3));
  CHECK(at(gcd(ur, {{Polynomial(), u}}), 5) == BivariatePolynomial::constant(5));
  CHECK(at(gcd({{-u}, {Polynomial(1)}}, {{Polynomial(), Polynomial(1)}}), 5) ==
        BivariatePolynomial::constant(1));
}

TEST_CASE("the common divisor of random products is the common factor") {
  const std::uint64_t seed = 20;
  INFO("seed " << seed);
  std::mt19937_64 generator(seed);
  for (int i = 0; i < 12; ++i) {
    const TrivariateCoefficients common = random_form(generator, 1, 2, 2);
    const TrivariateCoefficients a = product(common, random_form(generator, 2, 1, 1));
    const TrivariateCoefficients b = product(common, random_form(generator, 1, 1, 3));
    const TrivariateCoefficients found = gcd(a, b);
    // By the bivariate divisor at a u where the cofactors happen to be coprime, and up to a factor in u.
    for (const int u : {101, 103}) {
      const BivariatePolynomial expected = gcd(at(a, u), at(b, u));
      CHECK(exact_quotient(at(found, u), expected).degree_r() == 0);
      CHECK(exact_quotient(at(found, u), expected).degree_s() == 0);
    }
  }
}

}  // namespace
}  // namespace exsect::trivariate_gcd_test
