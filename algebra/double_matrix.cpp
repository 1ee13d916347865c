#include "double_matrix.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace exsect {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Index entry_index(std::size_t i) { return static_cast<Eigen::Index>(i); }

Eigen::MatrixXd to_eigen(const DoubleMatrix& m) {
  return Eigen::Map<const RowMajor>(m.data(), entry_index(m.rows()), entry_index(m.columns()));
}

Eigen::VectorXd to_eigen(const std::vector<double>& v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), entry_index(v.size()));
}

std::vector<double> from_eigen(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

Row3 cross_product(const Row3& a, const Row3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

void DoubleMatrix::append(const DoubleMatrix& below) {
  entries_.insert(entries_.end(), below.entries_.begin(), below.entries_.end());
}

bool DoubleMatrix::is_finite() const {
  return std::all_of(entries_.begin(), entries_.end(), [](double e) { return std::isfinite(e); });
}

LeastSingular least_singular(const DoubleMatrix& m) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(to_eigen(m), Eigen::ComputeFullV);
  return {decomposition.singularValues()[entry_index(m.columns() - 1)],
          from_eigen(decomposition.matrixV().rightCols<1>())};
}

DoubleMatrix square_root_rows(const DoubleMatrix& m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(to_eigen(m));
  const Eigen::VectorXd roots = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Eigen::MatrixXd rows = roots.asDiagonal() * solver.eigenvectors().transpose();
  DoubleMatrix result(m.rows(), m.columns());
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.columns(); ++j) result(i, j) = rows(entry_index(i), entry_index(j));
  return result;
}

LeastSquares least_squares(const DoubleMatrix& m, const std::vector<double>& right) {
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(to_eigen(m));
  return {from_eigen(decomposition.solve(to_eigen(right))), decomposition.rank() == entry_index(m.columns())};
}

std::vector<double> solution(const DoubleMatrix& m, const std::vector<double>& right) {
  return from_eigen(to_eigen(m).partialPivLu().solve(to_eigen(right)));
}

std::vector<double> symmetric_solution(const DoubleMatrix& m, const std::vector<double>& right) {
  const Eigen::MatrixXd dense = to_eigen(m);
  return from_eigen(dense.selfadjointView<Eigen::Lower>().ldlt().solve(to_eigen(right)));
}

std::optional<Matrix3> approximate_inverse(const std::array<Row3, 3>& column) {
  Matrix3 inverse = {cross_product(column[1], column[2]), cross_product(column[2], column[0]),
                     cross_product(column[0], column[1])};
  const double determinant =
      column[0][0] * inverse[0][0] + column[0][1] * inverse[0][1] + column[0][2] * inverse[0][2];
  if (!(std::fabs(determinant) > 0) || !std::isfinite(1 / determinant)) return std::nullopt;
  for (Row3& row : inverse)
    for (double& entry : row) entry /= determinant;
  return inverse;
}

std::vector<double> sparse_solution(const std::vector<SparseEntry>& entries,
                                    const std::vector<double>& right) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (const SparseEntry& e : entries)
    triplets.emplace_back(static_cast<int>(e.row), static_cast<int>(e.column), e.value);
  Eigen::SparseMatrix<double> matrix(entry_index(right.size()), entry_index(right.size()));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> decomposition(matrix);
  if (decomposition.info() != Eigen::Success) return {};
  return from_eigen(decomposition.solve(to_eigen(right)));
}

}  // namespace exsect
