// Preconditioners: 3 x 3 matrices of plain doubles for systems in the four parameters. Internal to solver/.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "pair_system.h"

namespace exsect {

using Row3 = std::array<double, 3>;
using Matrix3 = std::array<Row3, 3>;

/// The three parameters other than `axis`, ascending.
inline std::array<std::size_t, 3> other_axes(std::size_t axis) {
  std::array<std::size_t, 3> result{};
  std::size_t n = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    if (j != axis) {
      result[n++] = j;
    }
  }
  return result;
}

/// Inverse of the matrix with the given columns, in plain doubles: any matrix is a legal preconditioner.
inline std::optional<Matrix3> approximate_inverse(const std::array<Row3, 3>& column) {
  const auto minor = [&](std::size_t a, std::size_t b) {
    return Row3{column[a][1] * column[b][2] - column[a][2] * column[b][1],
                column[a][2] * column[b][0] - column[a][0] * column[b][2],
                column[a][0] * column[b][1] - column[a][1] * column[b][0]};
  };
  Matrix3 inverse = {minor(1, 2), minor(2, 0), minor(0, 1)};
  const double det =
      column[0][0] * inverse[0][0] + column[0][1] * inverse[0][1] + column[0][2] * inverse[0][2];
  if (!(std::fabs(det) > 0) || !std::isfinite(1 / det)) {
    return std::nullopt;
  }
  for (Row3& row : inverse) {
    for (double& entry : row) {
      entry /= det;
    }
  }
  return inverse;
}

/// c v, enclosed.
template <class Ball>
BallVector<Ball> preconditioned(const Matrix3& c, const BallVector<Ball>& v) {
  BallVector<Ball> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = Ball(c[i][0]) * v[0] + Ball(c[i][1]) * v[1] + Ball(c[i][2]) * v[2];
  }
  return result;
}

}  // namespace exsect
