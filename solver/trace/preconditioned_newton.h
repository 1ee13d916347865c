// Newton's method for three equations in four unknowns, one of which is held: preconditioners are 3 x 3
// matrices of plain doubles, or of midpoints of balls where columns may be nearly dependent. Internal to
// solver/.
#pragma once

#include <exsect/algebra/double_matrix.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "trace/pair_system.h"

namespace exsect {

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

/// c v, enclosed.
template <class Ball>
BallVector<Ball> preconditioned(const Matrix3& c, const BallVector<Ball>& v) {
  BallVector<Ball> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = Ball(c[i][0]) * v[0] + Ball(c[i][1]) * v[1] + Ball(c[i][2]) * v[2];
  }
  return result;
}

/// A matrix of balls of radius 0, by rows.
template <class Ball>
using BallMatrix = std::array<BallVector<Ball>, 3>;

/// Bits to which reciprocals are found: nearly those of the balls.
template <class Ball>
constexpr int kReciprocalBits = 212;
template <long Bits>
inline constexpr int kReciprocalBits<ArbBall<Bits>> = static_cast<int>(Bits - Bits / 5);

/// 1/a at the precision of the balls, approximately; empty if that exceeds the range of doubles.
template <class Ball>
std::optional<Ball> approximate_reciprocal(const Ball& a) {
  const double first = 1 / a.approximation();
  if (!std::isfinite(first)) {
    return std::nullopt;
  }
  const Ball middle = a.midpoint();
  Ball result(first);
  for (int correct_bits = 53; correct_bits < kReciprocalBits<Ball>; correct_bits *= 2) {
    result = (result * (Ball(2) - middle * result)).midpoint();
  }
  return result;
}

/// The inverse at the precision of the balls, from the midpoints of the columns: an inverse in doubles of
/// columns that are dependent up to e errs by 2^-53/e relatively, and a slope with that error limits the
/// reach of tubes.
template <class Ball>
std::optional<BallMatrix<Ball>> approximate_inverse(const std::array<BallVector<Ball>, 3>& column) {
  const auto midpoints = [](const BallVector<Ball>& v) {
    return BallVector<Ball>{v[0].midpoint(), v[1].midpoint(), v[2].midpoint()};
  };
  const BallVector<Ball> a = midpoints(column[0]), b = midpoints(column[1]), c = midpoints(column[2]);
  BallMatrix<Ball> inverse = {cross(b, c), cross(c, a), cross(a, b)};
  const std::optional<Ball> reciprocal = approximate_reciprocal(dot(a, inverse[0]));
  if (!reciprocal) {
    return std::nullopt;
  }
  for (BallVector<Ball>& row : inverse) {
    for (Ball& entry : row) {
      entry = (entry * *reciprocal).midpoint();
    }
  }
  return inverse;
}

/// c v, enclosed.
template <class Ball>
BallVector<Ball> preconditioned(const BallMatrix<Ball>& c, const BallVector<Ball>& v) {
  return {dot(c[0], v), dot(c[1], v), dot(c[2], v)};
}

template <class Ball>
double largest_radius(const BallPoint<Ball>& box) {
  return larger_bound(box[0].radius(), box[1].radius(), box[2].radius(), box[3].radius());
}

template <class Ball>
double largest_magnitude(const BallVector<Ball>& v) {
  return larger_bound(v[0].upper_magnitude(), v[1].upper_magnitude(), v[2].upper_magnitude());
}

/// Approximate Newton steps from the midpoints of `start` (an estimate, not a proof) in the coordinates other
/// than `axis`: `correction` of a point is an optional vector, what has to be taken away. Empty if a
/// correction is, or if the point leaves a neighbourhood of the unit cube.
template <class Ball, class Correction>
std::optional<BallPoint<Ball>> newton_steps(const BallPoint<Ball>& start, std::size_t axis, int steps,
                                            const Correction& correction) {
  const auto others = other_axes(axis);
  BallPoint<Ball> p;
  for (std::size_t j = 0; j < 4; ++j) {
    p[j] = start[j].midpoint();
  }
  for (int i = 0; i < steps; ++i) {
    const std::optional<BallVector<Ball>> c = correction(p);
    if (!c) {
      return std::nullopt;
    }
    for (std::size_t row = 0; row < 3; ++row) {
      p[others[row]] = (p[others[row]] - (*c)[row]).midpoint();
      if (!(p[others[row]].upper_magnitude() < 4)) {
        return std::nullopt;
      }
    }
  }
  return p;
}

/// A point and upper bounds of the preconditioned residual there, by rows.
template <class Ball>
struct Iterate {
  BallPoint<Ball> point;
  Row3 residual;
};

/// p - residual(p), again and again while the residual shrinks by a quarter and is above `enough`; coordinate
/// `axis` is held.
template <class Ball, class Residual>
Iterate<Ball> contracted(BallPoint<Ball> p, std::size_t axis, const Residual& residual, double enough = 0) {
  const auto others = other_axes(axis);
  double least = std::numeric_limits<double>::infinity();
  Iterate<Ball> best{p, {least, least, least}};
  for (int i = 0; i < 60; ++i) {
    const BallVector<Ball> r = residual(p);
    const double error = largest_magnitude(r);
    if (!(error < 0.75 * least)) {
      break;
    }
    least = error;
    best = {p, {r[0].upper_magnitude(), r[1].upper_magnitude(), r[2].upper_magnitude()}};
    if (error <= enough) {
      break;
    }
    for (std::size_t row = 0; row < 3; ++row) {
      p[others[row]] = (p[others[row]] - r[row]).midpoint();
    }
  }
  return best;
}

}  // namespace exsect
