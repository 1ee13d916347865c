// Vectors of R^3 in doubles beside those in balls, for guesses and for the rows of inverses. Internal to
// solver/.
#pragma once

#include <array>

#include "trace/pair_system.h"

namespace exsect {

inline std::array<double, 3> middle(const BallVector<DoubleBall>& a) {
  return {a[0].approximation(), a[1].approximation(), a[2].approximation()};
}

inline double product(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline DoubleBall product(const std::array<double, 3>& row, const BallVector<DoubleBall>& a) {
  return DoubleBall(row[0]) * a[0] + DoubleBall(row[1]) * a[1] + DoubleBall(row[2]) * a[2];
}

/// Of the matrix with these columns, but for rounding.
inline std::array<std::array<double, 3>, 3> inverse(const std::array<BallVector<DoubleBall>, 3>& columns) {
  std::array<std::array<double, 3>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto a = middle(columns[(i + 1) % 3]), b = middle(columns[(i + 2) % 3]);
    rows[i] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  const double determinant = product(rows[0], middle(columns[0]));
  for (auto& row : rows)
    for (double& entry : row) entry /= determinant;
  return rows;
}

}  // namespace exsect
