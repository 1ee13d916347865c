// The Jacobian of the equations of a curve along which the patches touch, and how far it is from its value at
// a point. Internal to solver/; docs/method.md, section 6.6.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>

#include "trace/contact_expansion.h"

namespace exsect {

/// C and the slope for one axis.
struct Linearisation {
  std::size_t axis;
  Matrix3 preconditioner;
  std::array<double, 4> slope;
};

template <class Ball>
std::optional<Linearisation> linearised(const ContactEquations<Ball>& phi, std::size_t axis) {
  const auto jacobian = linear_part(phi, axis);
  const auto others = other_axes(axis);
  std::array<Row3, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t row = 0; row < 3; ++row) {
      columns[i][row] = jacobian[row][others[i]].approximation();
    }
  }
  const auto c = approximate_inverse(columns);
  if (!c) {
    return std::nullopt;
  }
  Linearisation result{axis, *c, {}};
  result.slope[axis] = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t row = 0; row < 3; ++row) {
      result.slope[others[i]] -= (*c)[i][row] * jacobian[row][axis].approximation();
    }
  }
  return result;
}

inline double power(double x, std::size_t n) { return n == 0 ? 1 : n == 1 ? x : n == 2 ? x * x : x * x * x; }

/// Bounds of |d_j g - ideal| over |offset in parameter i| <= h[i], [row][parameter]; g = C Phi around a
/// centre, ideal = identity for j != axis and -d for j = axis.
using JacobianDeviation = std::array<std::array<double, 4>, 3>;

template <class Ball>
JacobianDeviation jacobian_deviation(const ContactEquations<Ball>& g, std::size_t axis,
                                     const std::array<double, 4>& slope, const std::array<double, 4>& h) {
  const auto variables = contact_variables(axis);
  const auto others = other_axes(axis);
  const auto linear = linear_part(g, axis);
  std::array<std::array<double, 4>, 4> p;  // powers of the widths, with one factor less in `less`
  std::array<std::array<double, 4>, 4> less{};
  for (std::size_t w = 0; w < 4; ++w) {
    for (std::size_t n = 0; n < 4; ++n) {
      p[w][n] = power(h[variables[w]], n);
      less[w][n] = n == 0 ? 0 : p[w][n - 1];
    }
  }
  JacobianDeviation result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t j = 0; j < 4; ++j) {
      const double ideal = j == axis ? -slope[others[row]] : (others[row] == j ? 1.0 : 0.0);
      result[row][j] = (linear[row][j] - Ball(ideal)).upper_magnitude();
    }
    std::array<double, 4> sum;
    for (std::size_t v = 0; v < 4; ++v) {
      sum[v] = result[row][variables[v]];
    }
    for_each_term([&](std::size_t t, const std::array<std::size_t, 4>& e) {
      const double c = e[0] + e[1] + e[2] + e[3] < 2 ? 0 : g[row].c[t].upper_magnitude();
      if (c == 0) {
        return;
      }
      const auto [i, j, k, l] = e;
      if (i > 0) {
        sum[0] += c * static_cast<double>(i) * less[0][i] * p[1][j] * p[2][k] * p[3][l];
      }
      if (j > 0) {
        sum[1] += c * static_cast<double>(j) * p[0][i] * less[1][j] * p[2][k] * p[3][l];
      }
      if (k > 0) {
        sum[2] += c * static_cast<double>(k) * p[0][i] * p[1][j] * less[2][k] * p[3][l];
      }
      if (l > 0) {
        sum[3] += c * static_cast<double>(l) * p[0][i] * p[1][j] * p[2][k] * less[3][l];
      }
    });
    for (std::size_t v = 0; v < 4; ++v) {
      result[row][variables[v]] = sum[v];
    }
  }
  return result;
}

inline double largest_row_sum(const JacobianDeviation& e, std::size_t axis) {
  double largest = 0;
  for (const auto& row : e) {
    double sum = 0;
    for (const std::size_t j : other_axes(axis)) {
      sum += row[j];
    }
    largest = larger_bound(largest, sum);
  }
  return kSlack * largest;
}

/// |C Phi'(box) d| <= sum_j E_j |d_j|: the ideal matrix maps d to 0.
inline double direction_residual(const JacobianDeviation& e, const std::array<double, 4>& d) {
  double largest = 0;
  for (const auto& row : e) {
    double sum = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      sum += row[j] * std::fabs(d[j]);
    }
    largest = larger_bound(largest, sum);
  }
  return kSlack * largest;
}

}  // namespace exsect
