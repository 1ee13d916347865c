// What proving a tube and finding points on it share: its line, its preconditioner and C F along it. Internal
// to solver/.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>

#include "trace/preconditioned_newton.h"
#include "trace/tube_line.h"

namespace exsect::tubes {

inline constexpr int kRowSteps = 4;

/// base + E bound, by rows.
inline Row3 through(const std::array<Row3, 4>& e, const std::array<std::size_t, 3>& others, const Row3& base,
                    const Row3& bound) {
  Row3 result{};
  for (std::size_t row = 0; row < 3; ++row) {
    double sum = base[row];
    for (std::size_t i = 0; i < 3; ++i) {
      sum += e[others[i]][row] * bound[i];
    }
    result[row] = kSlack * sum;
  }
  return result;
}

/// Bounds of |t| for any t with |t_i| <= base_i + sum E_ij |t_j|: the largest one first, by rho, and then row
/// by row, since the rows may be of very different size.
inline Row3 bound_solution(const std::array<Row3, 4>& e, const std::array<std::size_t, 3>& others,
                           const Row3& base, double contraction) {
  const double largest = larger_bound(base[0], base[1], base[2]);
  Row3 bound;
  for (std::size_t row = 0; row < 3; ++row) {
    bound[row] = kSlack * (base[row] + contraction / (1 - contraction) * kSlack * largest);
  }
  for (int step = 0; step < kRowSteps; ++step) {
    const Row3 next = through(e, others, base, bound);
    for (std::size_t row = 0; row < 3; ++row) {
      bound[row] = std::min(bound[row], next[row]);
    }
  }
  return bound;
}

/// l_j(sigma)
template <class Ball>
Ball on_line(const Tube<Ball>& tube, std::size_t j, const Ball& sigma) {
  Ball sum = tube.line.back()[j];
  for (std::size_t k = tube.line.size() - 1; k > 0; --k) {
    sum = tube.line[k - 1][j] + sigma * sum;
  }
  return sigma * sum;
}

/// C M^-1 at tau = scale sigma.
template <class Ball>
BallMatrix<Ball> preconditioner_at(const Tube<Ball>& tube, const Ball& sigma) {
  BallMatrix<Ball> c = tube.preconditioner.back();
  for (std::size_t k = tube.preconditioner.size() - 1; k > 0; --k) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t i = 0; i < 3; ++i) {
        c[row][i] = tube.preconditioner[k - 1][row][i] + sigma * c[row][i];
      }
    }
  }
  return c;
}

/// The net's value at the offset (a,b).
template <class Ball>
BallVector<Ball> value_at(const TaylorNet<Ball>& net, const Ball& a, const Ball& b) {
  BallVector<Ball> result;
  for (std::size_t row = 0; row < 3; ++row) {
    const Ball c0 = net[0][row] + b * (net[1][row] + b * net[2][row]);
    const Ball c1 = net[3][row] + b * (net[4][row] + b * net[5][row]);
    const Ball c2 = net[6][row] + b * (net[7][row] + b * net[8][row]);
    result[row] = c0 + a * (c1 + a * c2);
  }
  return result;
}

/// C F(p + offset), `c` = C M^-1
template <class Ball>
BallVector<Ball> premultiplied_value(const Tube<Ball>& tube, const BallMatrix<Ball>& c,
                                     const BallPoint<Ball>& o) {
  const BallVector<Ball> x = value_at(tube.nets[0], o[0], o[1]);
  const BallVector<Ball> y = value_at(tube.nets[1], o[2], o[3]);
  return preconditioned(c, {x[0] + y[0], x[1] + y[1], x[2] + y[2]});
}

}  // namespace exsect::tubes
