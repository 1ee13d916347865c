// Dense matrices over Q: rank, null space, linear systems. Exact.
#pragma once

#include <exsect/algebra/rational.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace exsect {

/// A matrix with entries in Q, zero at first. Either size may be 0.
class RationalMatrix {
 public:
  RationalMatrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), entries_(rows * columns) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  /// Requires row < rows() and column < columns().
  Rational& operator()(std::size_t row, std::size_t column) { return entries_[row * columns_ + column]; }
  const Rational& operator()(std::size_t row, std::size_t column) const {
    return entries_[row * columns_ + column];
  }

 private:
  std::size_t rows_;
  std::size_t columns_;
  std::vector<Rational> entries_;
};

/// Rank over Q.
std::size_t rank(const RationalMatrix& a);

/// A basis of {b : A b = 0}: columns() - rank(a) vectors, each of coprime integers whose last nonzero one is
/// positive.
std::vector<std::vector<Integer>> null_space(const RationalMatrix& a);

/// The solution of A b = c for a square A; empty if A is singular. Throws std::invalid_argument unless A is
/// square and c has as many elements as A has rows.
std::optional<std::vector<Rational>> solve(const RationalMatrix& a, const std::vector<Rational>& c);

}  // namespace exsect
