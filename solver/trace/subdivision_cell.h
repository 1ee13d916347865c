// The cells of one patch in a subdivision: rectangles of its parameter square with the Bernstein nets of
// their sub-patches, boxes and derivatives. Internal to solver/.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "trace/tracer.h"

namespace exsect::subdivision {

/// Closed interval of doubles around everything a ball may be: the last terms cover the rounding of the
/// difference and of approximation().
struct Bounds {
  double lower;
  double upper;
};
template <class Ball>
Bounds bounds(const Ball& b) {
  const double a = b.approximation();
  const double r = b.radius() * kSlack + 0x1p-50 * std::fabs(a) + kUnderflowLoss;
  return {a - r, a + r};
}

inline DoubleBall enclose(const Bounds& b) {
  const double mid = 0.5 * (b.lower + b.upper);
  const double rad = std::max(b.upper - mid, mid - b.lower);
  return DoubleBall(mid, 0).widened(rad * kSlack + 0x1p-50 * std::fabs(mid));
}

inline Bounds hull(const Bounds& a, const Bounds& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

using DirectionBox = std::array<DoubleBall, 3>;

/// A rectangle of one parameter square with the Bernstein net of its sub-patch.
template <class Ball>
struct Cell {
  std::array<double, 2> lower;
  std::array<double, 2> upper;
  std::array<BallVector<Ball>, 9> net;  // [3 i + j]
  std::array<Bounds, 3> box;
  std::array<DirectionBox, 2> derivative;  // with respect to the cell's own unit square, divided by 2
  std::array<double, 3> normal;            // approximate, any direction is legal
  double size;
  int depth;
  std::array<Cell*, 4> children = {};
};

template <class Ball>
void complete(Cell<Ball>& cell) {
  cell.size = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    cell.box[c] = bounds(cell.net[0][c]);
    for (std::size_t i = 1; i < 9; ++i) {
      cell.box[c] = hull(cell.box[c], bounds(cell.net[i][c]));
    }
    cell.size = std::max(cell.size, cell.box[c].upper - cell.box[c].lower);
    for (std::size_t direction = 0; direction < 2; ++direction) {
      const std::size_t step = direction == 0 ? 3 : 1;
      Bounds all = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
      for (std::size_t i = 0; i < 9; ++i) {
        if (direction == 0 ? i < 6 : i % 3 < 2) {
          all = hull(all, bounds(cell.net[i + step][c] - cell.net[i][c]));
        }
      }
      cell.derivative[direction][c] = enclose(all);
    }
  }
  const auto& a = cell.derivative[0];
  const auto& b = cell.derivative[1];
  const auto mid = [](const DoubleBall& ball) { return ball.approximation(); };
  cell.normal = {mid(a[1]) * mid(b[2]) - mid(a[2]) * mid(b[1]), mid(a[2]) * mid(b[0]) - mid(a[0]) * mid(b[2]),
                 mid(a[0]) * mid(b[1]) - mid(a[1]) * mid(b[0])};
}

/// de Casteljau at 1/2 of three consecutive points with the given stride: left and right halves.
template <class Ball>
void halve(const std::array<BallVector<Ball>, 9>& net, std::size_t first, std::size_t stride,
           std::array<BallVector<Ball>, 9>& left, std::array<BallVector<Ball>, 9>& right) {
  const Ball half(0.5);
  for (std::size_t c = 0; c < 3; ++c) {
    const Ball& p0 = net[first][c];
    const Ball& p1 = net[first + stride][c];
    const Ball& p2 = net[first + 2 * stride][c];
    const Ball q0 = half * (p0 + p1);
    const Ball q1 = half * (p1 + p2);
    const Ball m = half * (q0 + q1);
    left[first][c] = p0;
    left[first + stride][c] = q0;
    left[first + 2 * stride][c] = m;
    right[first][c] = m;
    right[first + stride][c] = q1;
    right[first + 2 * stride][c] = p2;
  }
}

/// The cells of one patch, split into four or two on demand.
template <class Ball>
class CellTree {
 public:
  CellTree(const TaylorNet<Ball>& taylor_at_corner, const std::array<double, 2>& lower,
           const std::array<double, 2>& upper) {
    Cell<Ball> root;
    root.lower = lower;
    root.upper = upper;
    root.depth = 0;
    // Power basis in the cell's own coordinates, then b = power + shifts (degree 2 in each direction).
    const std::array<Ball, 2> width = {Ball(upper[0]) - Ball(lower[0]), Ball(upper[1]) - Ball(lower[1])};
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<Ball, 9> a;
      for (std::size_t i = 0; i < 9; ++i) {
        a[i] = taylor_at_corner[i][c];
        for (std::size_t k = 0; k < i / 3; ++k) {
          a[i] *= width[0];
        }
        for (std::size_t k = 0; k < i % 3; ++k) {
          a[i] *= width[1];
        }
      }
      to_bernstein(a, 3, 1);
      to_bernstein(a, 1, 3);
      for (std::size_t i = 0; i < 9; ++i) {
        root.net[i][c] = a[i];
      }
    }
    complete(root);
    cells_.push_back(std::move(root));
  }

  Cell<Ball>& root() { return cells_.front(); }

  /// False if the midpoints are not doubles: the cell cannot be split. In a direction in which it is thin it
  /// is left as it is, and there are two children, the others null.
  bool split(Cell<Ball>& cell) {
    if (cell.children[0] != nullptr) {
      return true;
    }
    std::array<double, 2> middle{};
    for (std::size_t k = 0; k < 2; ++k) {
      middle[k] = 0.5 * (cell.lower[k] + cell.upper[k]);
      if (middle[k] - cell.lower[k] != cell.upper[k] - middle[k] || !(middle[k] > cell.lower[k])) {
        return false;
      }
    }
    const double first = extent(cell.derivative[0]);
    const double second = extent(cell.derivative[1]);
    const std::size_t rows = kThin * first < second ? 1 : 2;
    const std::size_t columns = kThin * second < first ? 1 : 2;
    std::array<Net, 2> half = {cell.net, cell.net};
    for (std::size_t j = 0; j < 3 && rows == 2; ++j) {
      halve(cell.net, j, 3, half[0], half[1]);
    }
    for (std::size_t a = 0; a < rows; ++a) {
      std::array<Net, 2> quarter = {half[a], half[a]};
      for (std::size_t i = 0; i < 9 && columns == 2; i += 3) {
        halve(half[a], i, 1, quarter[0], quarter[1]);
      }
      for (std::size_t b = 0; b < columns; ++b) {
        Cell<Ball> child;
        child.lower = {a == 0 ? cell.lower[0] : middle[0], b == 0 ? cell.lower[1] : middle[1]};
        child.upper = {a + 1 == rows ? cell.upper[0] : middle[0],
                       b + 1 == columns ? cell.upper[1] : middle[1]};
        child.net = std::move(quarter[b]);
        child.depth = cell.depth + 1;
        complete(child);
        cells_.push_back(std::move(child));
        cell.children[2 * a + b] = &cells_.back();
      }
    }
    return true;
  }

 private:
  using Net = std::array<BallVector<Ball>, 9>;
  static constexpr double kThin = 4;

  static double extent(const DirectionBox& derivative) {
    return larger_bound(derivative[0].upper_magnitude(), derivative[1].upper_magnitude(),
                        derivative[2].upper_magnitude());
  }

  /// Power to Bernstein, degree 2: b0 = a0, b1 = a0 + a1/2, b2 = a0 + a1 + a2, along `stride`.
  static void to_bernstein(std::array<Ball, 9>& a, std::size_t stride, std::size_t other) {
    for (std::size_t i = 0; i < 3; ++i) {
      Ball& a0 = a[i * other];
      Ball& a1 = a[i * other + stride];
      Ball& a2 = a[i * other + 2 * stride];
      a2 = a0 + a1 + a2;
      a1 = a0 + Ball(0.5) * a1;
    }
  }

  std::deque<Cell<Ball>> cells_;  // stable addresses
};

}  // namespace exsect::subdivision
