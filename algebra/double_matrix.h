// Linear algebra in doubles, without error bounds: where an approximation is found that is judged exactly
// later.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace exsect {

/// rows x columns doubles, stored by rows.
class DoubleMatrix {
 public:
  DoubleMatrix(std::size_t rows, std::size_t columns) : columns_(columns), entries_(rows * columns, 0.0) {}

  std::size_t rows() const { return columns_ == 0 ? 0 : entries_.size() / columns_; }
  std::size_t columns() const { return columns_; }
  double& operator()(std::size_t i, std::size_t j) { return entries_[i * columns_ + j]; }
  double operator()(std::size_t i, std::size_t j) const { return entries_[i * columns_ + j]; }
  const double* data() const { return entries_.data(); }
  /// The rows of both, which have as many columns.
  void append(const DoubleMatrix& below);
  bool is_finite() const;

 private:
  std::size_t columns_;  // > 0
  std::vector<double> entries_;
};

/// The least singular value and its right singular vector, of length 1.
struct LeastSingular {
  double value;
  std::vector<double> vector;
};
/// Requires at least as many rows as columns; not finite where the matrix is not.
LeastSingular least_singular(const DoubleMatrix& m);

/// R with R'R = m, m symmetric; negative eigenvalues are taken as 0.
DoubleMatrix square_root_rows(const DoubleMatrix& m);

struct LeastSquares {
  std::vector<double> solution;  // of least norm
  bool is_unique;                // the columns are numerically independent
};
/// The x with the least |m x - right|.
LeastSquares least_squares(const DoubleMatrix& m, const std::vector<double>& right);

/// The solution of m x = right for a square matrix, by elimination; not finite if it is singular.
std::vector<double> solution(const DoubleMatrix& m, const std::vector<double>& right);
/// The same for a symmetric matrix, of which the lower triangle is read.
std::vector<double> symmetric_solution(const DoubleMatrix& m, const std::vector<double>& right);

using Row3 = std::array<double, 3>;
using Matrix3 = std::array<Row3, 3>;  // by rows

/// The inverse of the matrix with these columns; empty if the determinant is 0 or not a number, or its
/// reciprocal is not finite.
std::optional<Matrix3> approximate_inverse(const std::array<Row3, 3>& column);

struct SparseEntry {
  std::size_t row;
  std::size_t column;
  double value;
};
/// The solution for a positive definite sparse matrix of `right.size()` rows, each entry given once; empty if
/// it is not definite. Throws nothing.
std::vector<double> sparse_solution(const std::vector<SparseEntry>& entries,
                                    const std::vector<double>& right);

}  // namespace exsect
