#include <exsect/algebra/double_matrix.h>
#include <exsect/algebra/rational_matrix.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/catch.h"

namespace exsect::double_matrix_test {

namespace {

DoubleMatrix random_matrix(std::mt19937& random, std::size_t rows, std::size_t columns) {
  std::uniform_int_distribution<int> entry(-9, 9);
  DoubleMatrix m(rows, columns);
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) m(i, j) = entry(random);
  return m;
}

RationalMatrix exactly(const DoubleMatrix& m) {
  RationalMatrix result(m.rows(), m.columns());
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.columns(); ++j) result(i, j) = from_double(m(i, j));
  return result;
}

/// |m v|
double length_of_image(const DoubleMatrix& m, const std::vector<double>& v) {
  double sum = 0;
  for (std::size_t i = 0; i < m.rows(); ++i) {
    double row = 0;
    for (std::size_t j = 0; j < m.columns(); ++j) row += m(i, j) * v[j];
    sum += row * row;
  }
  return std::sqrt(sum);
}

/// m'm, and m'm plus the identity.
DoubleMatrix gram(const DoubleMatrix& m, double shift) {
  DoubleMatrix g(m.columns(), m.columns());
  for (std::size_t j = 0; j < m.columns(); ++j)
    for (std::size_t k = 0; k < m.columns(); ++k) {
      g(j, k) = j == k ? shift : 0;
      for (std::size_t i = 0; i < m.rows(); ++i) g(j, k) += m(i, j) * m(i, k);
    }
  return g;
}

}  // namespace

TEST_CASE("awkward matrices: singular, not finite, without rows", "[double_matrix]") {
  DoubleMatrix zero(2, 2);
  CHECK(least_singular(zero).value == 0);
  CHECK_FALSE(least_squares(zero, {1, 1}).is_unique);
  CHECK_FALSE(std::isfinite(solution(zero, {1, 1})[0]));
  DoubleMatrix none(0, 3);
  CHECK(none.rows() == 0);
  DoubleMatrix wrong(1, 1);
  wrong(0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(wrong.is_finite());
  CHECK(sparse_solution({{0, 0, 0.0}, {1, 1, 1.0}}, {1, 1}).empty());
}

TEST_CASE("solutions are those of exact elimination", "[double_matrix]") {
  const unsigned seed = 20261122;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 40; ++round) {
    const std::size_t n = 1 + static_cast<std::size_t>(round) % 6;
    const DoubleMatrix any = random_matrix(random, n + 2, n);
    const DoubleMatrix m = gram(any, 1);
    const DoubleMatrix column = random_matrix(random, n, 1);
    std::vector<double> right;
    std::vector<Rational> exact_right;
    std::vector<SparseEntry> entries;
    for (std::size_t i = 0; i < n; ++i) {
      right.push_back(column(i, 0));
      exact_right.push_back(from_double(column(i, 0)));
      for (std::size_t j = 0; j < n; ++j)
        if (m(i, j) != 0) entries.push_back({i, j, m(i, j)});
    }
    const auto exact = solve(exactly(m), exact_right);
    REQUIRE(exact);
    const auto agrees = [&](const std::vector<double>& x) {
      REQUIRE(x.size() == n);
      for (std::size_t i = 0; i < n; ++i) CHECK(x[i] == Approx(to_double((*exact)[i])).margin(1e-9));
    };
    agrees(solution(m, right));
    agrees(symmetric_solution(m, right));
    agrees(sparse_solution(entries, right));
    agrees(least_squares(m, right).solution);
  }
}

TEST_CASE("the inverse of a matrix by its columns", "[double_matrix]") {
  const auto inverse = approximate_inverse({Row3{1, 0, 2}, Row3{0, 4, 0}, Row3{1, 1, 4}});
  REQUIRE(inverse);
  CHECK(*inverse == Matrix3{Row3{2, 0, -0.5}, Row3{0.25, 0.25, -0.125}, Row3{-1, 0, 0.5}});
  CHECK_FALSE(approximate_inverse({Row3{1, 2, 3}, Row3{2, 4, 6}, Row3{0, 0, 1}}));
  CHECK_FALSE(approximate_inverse({Row3{NAN, 0, 0}, Row3{0, 1, 0}, Row3{0, 0, 1}}));
  CHECK_FALSE(approximate_inverse({Row3{0x1p-1060, 0, 0}, Row3{0, 1, 0}, Row3{0, 0, 1}}));
}

TEST_CASE("least singular values and square roots satisfy what defines them", "[double_matrix]") {
  const unsigned seed = 7;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 20; ++round) {
    const DoubleMatrix m = random_matrix(random, 6, 4);
    const LeastSingular least = least_singular(m);
    CHECK(length_of_image(m, least.vector) == Approx(least.value).margin(1e-9));
    for (std::size_t j = 0; j < 4; ++j) {
      std::vector<double> unit(4, 0.0);
      unit[j] = 1;
      CHECK(length_of_image(m, unit) >= least.value - 1e-9);
    }
    const DoubleMatrix g = gram(m, 0);
    const DoubleMatrix again = gram(square_root_rows(g), 0);
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) CHECK(again(j, k) == Approx(g(j, k)).margin(1e-8));
  }
}

}  // namespace exsect::double_matrix_test
