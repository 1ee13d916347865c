#include "rational_matrix.h"

#include <stdexcept>

#include "flint.h"
// after flint.h
#include <flint/fmpz_mat.h>

namespace exsect {
namespace {

/// Owner of one fmpz_mat.
struct FlintMatrix {
  fmpz_mat_t value;

  FlintMatrix(std::size_t rows, std::size_t columns) {
    fmpz_mat_init(value, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ~FlintMatrix() { fmpz_mat_clear(value); }
  FlintMatrix(const FlintMatrix&) = delete;
  FlintMatrix& operator=(const FlintMatrix&) = delete;

  fmpz* at(std::size_t row, std::size_t column) {
    return fmpz_mat_entry(value, static_cast<slong>(row), static_cast<slong>(column));
  }
};

void set(fmpz* to, const Integer& n) { fmpz_set_mpz(to, n.backend().data()); }

Integer to_integer(const fmpz* n) {
  Integer result;
  fmpz_get_mpz(result.backend().data(), n);
  return result;
}

/// The least common denominator of the entries of a row.
Integer row_denominator(const RationalMatrix& a, std::size_t row) {
  Integer common = 1;
  for (std::size_t j = 0; j < a.columns(); ++j) common = lcm(common, denominator(a(row, j)));
  return common;
}

void set_row(FlintMatrix& to, const RationalMatrix& a, std::size_t row, const Integer& factor) {
  for (std::size_t j = 0; j < a.columns(); ++j) set(to.at(row, j), numerator(Rational(a(row, j) * factor)));
}

/// The matrix with its rows scaled to integers: the same null space.
void set_integer_rows(FlintMatrix& to, const RationalMatrix& a) {
  for (std::size_t i = 0; i < a.rows(); ++i) set_row(to, a, i, row_denominator(a, i));
}

std::vector<Integer> without_common_factor(std::vector<Integer> vector) {
  Integer common = 0;
  int sign = 1;
  for (const Integer& n : vector) {
    common = gcd(common, n);
    if (n != 0) sign = n < 0 ? -1 : 1;
  }
  if (common != 0)
    for (Integer& n : vector) n /= sign * common;
  return vector;
}

}  // namespace

std::size_t rank(const RationalMatrix& a) {
  FlintMatrix m(a.rows(), a.columns());
  set_integer_rows(m, a);
  return static_cast<std::size_t>(fmpz_mat_rank(m.value));
}

std::vector<std::vector<Integer>> null_space(const RationalMatrix& a) {
  FlintMatrix m(a.rows(), a.columns());
  set_integer_rows(m, a);
  FlintMatrix reduced(a.rows(), a.columns());
  FlintInteger pivot;  // the common value of all leading entries
  const auto rank = static_cast<std::size_t>(fmpz_mat_rref(reduced.value, pivot.value, m.value));
  std::vector<std::size_t> leading;  // column of the first nonzero entry of each row
  std::vector<bool> is_leading(a.columns(), false);
  for (std::size_t i = 0, j = 0; i < rank; ++i, ++j) {
    while (fmpz_is_zero(reduced.at(i, j))) ++j;
    leading.push_back(j);
    is_leading[j] = true;
  }
  std::vector<std::vector<Integer>> basis;
  for (std::size_t free = 0; free < a.columns(); ++free) {
    if (is_leading[free]) continue;
    std::vector<Integer> vector(a.columns());
    vector[free] = pivot.to_integer();
    for (std::size_t i = 0; i < rank; ++i) vector[leading[i]] = -to_integer(reduced.at(i, free));
    basis.push_back(without_common_factor(std::move(vector)));
  }
  return basis;
}

std::optional<std::vector<Rational>> solve(const RationalMatrix& a, const std::vector<Rational>& c) {
  if (a.rows() != a.columns() || c.size() != a.rows())
    throw std::invalid_argument("solve: the matrix must be square, with as many rows as the right hand side");
  const std::size_t n = a.rows();
  FlintMatrix left(n, n), right(n, 1), solution(n, 1);
  for (std::size_t i = 0; i < n; ++i) {
    const Integer factor = lcm(row_denominator(a, i), denominator(c[i]));
    set_row(left, a, i, factor);
    set(right.at(i, 0), numerator(Rational(c[i] * factor)));
  }
  FlintInteger common;
  if (fmpz_mat_solve(solution.value, common.value, left.value, right.value) == 0) return std::nullopt;
  std::vector<Rational> result;
  for (std::size_t i = 0; i < n; ++i) result.emplace_back(to_integer(solution.at(i, 0)), common.to_integer());
  return result;
}

}  // namespace exsect
