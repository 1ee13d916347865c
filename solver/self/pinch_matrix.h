// Vectors of R^3 in doubles beside those in balls, for guesses and for the rows of inverses. Internal to
// solver/.
#pragma once

#include <exsect/algebra/double_matrix.h>

#include <array>

#include "trace/pair_system.h"

namespace exsect {

inline Row3 middle(const BallVector<DoubleBall>& a) {
  return {a[0].approximation(), a[1].approximation(), a[2].approximation()};
}

inline double product(const Row3& a, const Row3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline DoubleBall product(const Row3& row, const BallVector<DoubleBall>& a) {
  return DoubleBall(row[0]) * a[0] + DoubleBall(row[1]) * a[1] + DoubleBall(row[2]) * a[2];
}

/// Of the matrix with these columns, but for rounding; 0, with which nothing is proved, if there is none.
inline Matrix3 inverse(const std::array<BallVector<DoubleBall>, 3>& columns) {
  return approximate_inverse({middle(columns[0]), middle(columns[1]), middle(columns[2])})
      .value_or(Matrix3{});
}

}  // namespace exsect
