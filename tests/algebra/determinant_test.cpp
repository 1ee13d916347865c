#include <exsect/algebra/determinant.h>

#include "random_numbers.h"
#include "support/catch.h"

namespace exsect::determinant_test {
using exsect::test::Random;

namespace {

using Matrix = std::vector<std::vector<BivariatePolynomial>>;

BivariatePolynomial random_bivariate(Random& random, int rows, int degree) {
  std::vector<Polynomial> coefficients;
  for (int i = 0; i < rows; ++i) coefficients.push_back(random.polynomial(degree, 9, 5));
  return BivariatePolynomial(coefficients);
}

/// Expansion along the first row.
BivariatePolynomial by_laplace(const Matrix& matrix) {
  if (matrix.empty()) return BivariatePolynomial::constant(1);
  BivariatePolynomial sum;
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    Matrix minor;
    for (std::size_t i = 1; i < matrix.size(); ++i) {
      minor.push_back(matrix[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(j));
    }
    const BivariatePolynomial term = matrix[0][j] * by_laplace(minor);
    if (j % 2 == 0)
      sum += term;
    else
      sum -= term;
  }
  return sum;
}

}  // namespace

TEST_CASE("determinants of special matrices", "[determinant]") {
  const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s(), zero;
  CHECK(determinant({}) == BivariatePolynomial::constant(1));
  CHECK(determinant({{zero}}).is_zero());
  CHECK(determinant({{r}}) == r);
  CHECK(determinant({{r, s}, {s, r}}) == r * r - s * s);
  CHECK(determinant({{r, s}, {r, s}}).is_zero());
  CHECK(determinant({{zero, s}, {r, zero}}) == zero - r * s);
  CHECK_THROWS_AS(determinant({{r, s}}), std::invalid_argument);
}

TEST_CASE("determinants equal their Laplace expansion", "[determinant]") {
  const auto seed = 41u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 12; ++round) {
    const int n = 1 + round % 4;
    Matrix matrix;
    for (int i = 0; i < n; ++i) {
      matrix.emplace_back();
      for (int j = 0; j < n; ++j)
        matrix.back().push_back(
            random_bivariate(random, random.integer(0, 3), random.integer(0, round > 6 ? 3 : 1)));
    }
    CHECK(determinant(matrix) == by_laplace(matrix));
  }
}

TEST_CASE("primitive multiples are positive, integer and coprime", "[determinant]") {
  const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
  const BivariatePolynomial f = r * Polynomial(Rational(-4, 9)) + s * Polynomial(Rational(10, 3));
  CHECK(primitive(f) == r * Polynomial(-2) + s * Polynomial(15));
  CHECK(primitive(BivariatePolynomial()).is_zero());
  CHECK(primitive(primitive(f)) == primitive(f));
}

}  // namespace exsect::determinant_test
