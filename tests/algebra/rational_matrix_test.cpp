#include <exsect/algebra/rational_matrix.h>

#include <random>

#include "support/catch.h"

namespace exsect::rational_matrix_test {
namespace {

RationalMatrix random_matrix(std::mt19937_64& random, std::size_t rows, std::size_t columns) {
  std::uniform_int_distribution<int> numerator(-9, 9), denominator(1, 7);
  RationalMatrix a(rows, columns);
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) a(i, j) = Rational(numerator(random), denominator(random));
  return a;
}

RationalMatrix product(const RationalMatrix& a, const RationalMatrix& b) {
  RationalMatrix c(a.rows(), b.columns());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < b.columns(); ++j)
      for (std::size_t k = 0; k < a.columns(); ++k) c(i, j) += a(i, k) * b(k, j);
  return c;
}

template <class Number>
std::vector<Rational> image(const RationalMatrix& a, const std::vector<Number>& b) {
  std::vector<Rational> result(a.rows());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j) result[i] += a(i, j) * b[j];
  return result;
}

TEST_CASE("matrices of the least sizes") {
  CHECK(rank(RationalMatrix(0, 0)) == 0);
  CHECK(null_space(RationalMatrix(0, 2)).size() == 2);
  CHECK(null_space(RationalMatrix(2, 0)).empty());
  CHECK(rank(RationalMatrix(2, 3)) == 0);
  CHECK(null_space(RationalMatrix(1, 1)) == std::vector<std::vector<Integer>>{{1}});
  CHECK(solve(RationalMatrix(0, 0), {}) == std::vector<Rational>{});
  CHECK_FALSE(solve(RationalMatrix(1, 1), {1}));
  CHECK_THROWS_AS(solve(RationalMatrix(1, 2), {1}), std::invalid_argument);
  CHECK_THROWS_AS(solve(RationalMatrix(1, 1), {1, 2}), std::invalid_argument);
}

TEST_CASE("the null space of a known matrix") {
  RationalMatrix a(2, 3);  // x/2 + y/3 = 0, z = 0
  a(0, 0) = Rational(1, 2);
  a(0, 1) = Rational(1, 3);
  a(1, 2) = -5;
  CHECK(rank(a) == 2);
  CHECK(null_space(a) == std::vector<std::vector<Integer>>{{-2, 3, 0}});
}

TEST_CASE("null spaces of products have the rank of their factors") {
  const std::uint64_t seed = 20260101;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  for (std::size_t r = 1; r <= 5; ++r) {
    const RationalMatrix a = product(random_matrix(random, 6, r), random_matrix(random, r, 7));
    CHECK(rank(a) == r);
    const std::vector<std::vector<Integer>> basis = null_space(a);
    REQUIRE(basis.size() == 7 - r);
    RationalMatrix together(basis.size(), 7);
    for (std::size_t i = 0; i < basis.size(); ++i) {
      CHECK(image(a, basis[i]) == std::vector<Rational>(6));
      Integer common = 0;
      for (std::size_t j = 0; j < 7; ++j) {
        together(i, j) = basis[i][j];
        common = gcd(common, basis[i][j]);
      }
      CHECK(common == 1);
    }
    CHECK(rank(together) == basis.size());
  }
}

TEST_CASE("solutions satisfy their system") {
  const std::uint64_t seed = 20260102;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  for (std::size_t n = 1; n <= 6; ++n) {
    const RationalMatrix a = random_matrix(random, n, n);
    const RationalMatrix wanted = random_matrix(random, n, 1);
    std::vector<Rational> b;
    for (std::size_t i = 0; i < n; ++i) b.push_back(wanted(i, 0));
    REQUIRE(rank(a) == n);
    CHECK(solve(a, image(a, b)) == b);
  }
}

}  // namespace
}  // namespace exsect::rational_matrix_test
