// Tubes about a line: the bounds of Lemma 5.1 for any polynomial equations of four variables, and what such a
// tube contains. Internal to solver/; docs/method.md, section 5.
//
// Equations g = C Phi, Phi from four variables to R^3, stand by their Taylor coefficients at a centre p. They
// have Number, the balls, and for_each_term(f), which calls f(e, c) for each of them, in any order: e the
// exponents, at most 3, and c the BallVector; those that are left out are 0.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "trace/tube_evaluation.h"

namespace exsect {

/// The region of all w with w_k = p_k + tau, |tau| <= reach, and |w_i - p_i - tau d_i| <= halfwidth for i !=
/// k; p centre, k axis, d slope (d_k = 1). The curve is one arc in it, a graph over tau, and |C D_j - 1| has
/// row sums of at most `contraction` < 1 there (columns j != k).
template <class Ball>
struct StraightTube {
  BallPoint<Ball> centre;  // radius 0
  std::size_t axis;
  std::array<double, 4> slope;
  double reach;
  double halfwidth;
  double contraction;
};

/// The offset tau of a point's coordinate k, enclosed.
template <class Ball>
Ball offset(const StraightTube<Ball>& tube, const BallPoint<Ball>& point) {
  return point[tube.axis] - tube.centre[tube.axis];
}

/// w_j - p_j - tau d_j
template <class Ball>
Ball from_line(const StraightTube<Ball>& tube, const BallPoint<Ball>& box, const Ball& tau, std::size_t j) {
  return box[j] - tube.centre[j] - tau * Ball(tube.slope[j]);
}

/// True only if the whole box lies in the part |w_i - p_i - tau d_i| <= width of the region.
template <class Ball>
bool contains_within(const StraightTube<Ball>& tube, const BallPoint<Ball>& box, double width) {
  const Ball tau = offset(tube, box);
  const auto others = other_axes(tube.axis);
  return tau.upper_magnitude() <= tube.reach && std::all_of(others.begin(), others.end(), [&](std::size_t j) {
           return from_line(tube, box, tau, j).upper_magnitude() <= width;
         });
}

/// Bounds of |w_j - p_j| on the region.
template <class Ball>
std::array<double, 4> half_widths(const StraightTube<Ball>& tube) {
  std::array<double, 4> h{};
  for (std::size_t j = 0; j < 4; ++j) {
    h[j] = kSlack * (std::fabs(tube.slope[j]) * tube.reach + (j == tube.axis ? 0 : tube.halfwidth));
  }
  return h;
}

/// C and d for one axis: C about the inverse of the derivatives by the other variables, d about tangent.
struct Linearisation {
  std::size_t axis;
  Matrix3 preconditioner;
  std::array<double, 4> slope;
};

/// For the derivatives of Phi at p; empty if they are numerically dependent.
template <class Ball>
std::optional<Linearisation> linearised(const std::array<BallVector<Ball>, 4>& derivative, std::size_t axis) {
  const auto approximate = [&](std::size_t j) {
    const BallVector<Ball>& c = derivative[j];
    return Row3{c[0].approximation(), c[1].approximation(), c[2].approximation()};
  };
  const auto others = other_axes(axis);
  const auto c =
      approximate_inverse({approximate(others[0]), approximate(others[1]), approximate(others[2])});
  if (!c) {
    return std::nullopt;
  }
  Linearisation result{axis, *c, {}};
  result.slope[axis] = 1;
  const Row3 along = approximate(axis);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t row = 0; row < 3; ++row) {
      result.slope[others[i]] -= (*c)[i][row] * along[row];
    }
  }
  return result;
}

using TermExponents = std::array<std::size_t, 4>;

/// Derivatives of monomials at a point h >= 0.
class MonomialsAt {
 public:
  explicit MonomialsAt(const std::array<double, 4>& h) : h_(h) {
    for (std::size_t v = 0; v < 4; ++v) power_[v] = {1, h[v], h[v] * h[v], h[v] * h[v] * h[v]};
  }

  double derivative(const TermExponents& e, std::size_t j) const {
    if (e[j] == 0) return 0;
    double value = static_cast<double>(e[j]) * power_[j][e[j] - 1];
    for (std::size_t v = 0; v < 4; ++v) value *= v == j ? 1 : power_[v][e[v]];
    return value;
  }
  /// In the direction a >= 0: twice the coefficient of t² of prod (h + t a)^e.
  double second(const TermExponents& e, const std::array<double, 4>& a) const {
    std::array<double, 3> product = {1, 0, 0};
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t i = 0; i < e[v]; ++i) {
        product[2] = product[2] * h_[v] + product[1] * a[v];
        product[1] = product[1] * h_[v] + product[0] * a[v];
        product[0] *= h_[v];
      }
    }
    return 2 * product[2];
  }

 private:
  std::array<double, 4> h_;
  std::array<std::array<double, 4>, 4> power_;
};

namespace straight {

inline std::size_t degree(const TermExponents& e) { return e[0] + e[1] + e[2] + e[3]; }

/// The two variables of a quadratic term, the same one twice for a square; that of a linear one, twice.
inline std::array<std::size_t, 2> variables(const TermExponents& e) {
  std::array<std::size_t, 2> result{};
  std::size_t n = 0;
  for (std::size_t v = 0; v < 4; ++v) {
    for (std::size_t i = 0; i < e[v]; ++i) result[n++] = v;
  }
  return n == 1 ? std::array{result[0], result[0]} : result;
}

template <class Coefficient>
Row3 magnitudes(const Coefficient& c) {
  return {c[0].upper_magnitude(), c[1].upper_magnitude(), c[2].upper_magnitude()};
}

}  // namespace straight

/// |g(p + tau d)| for |tau| <= reach, power by power of tau, by rows.
template <class Equations>
Row3 residual_on_line(const Equations& g, std::size_t axis, const std::array<double, 4>& slope,
                      double reach) {
  using Ball = typename Equations::Number;
  std::array<BallVector<Ball>, 13> by_degree;
  g.for_each_term([&](const TermExponents& e, const BallVector<Ball>& c) {
    BallVector<Ball> term = c;
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t n = v == axis ? e[v] : 0; n < e[v]; ++n) {
        for (Ball& entry : term) entry *= Ball(slope[v]);
      }
    }
    for (std::size_t row = 0; row < 3; ++row) by_degree[straight::degree(e)][row] += term[row];
  });
  Row3 sum{};
  double scale = 1;
  for (const BallVector<Ball>& coefficient : by_degree) {
    const Row3 m = straight::magnitudes(coefficient);
    for (std::size_t row = 0; row < 3; ++row) sum[row] += m[row] * scale;
    scale = std::max(scale * reach, std::numeric_limits<double>::min());
  }
  for (double& bound : sum) bound *= kSlack;
  return sum;
}

/// Bounds of |d_j g - ideal| by columns j, ideal = identity for j != axis and -d for j = axis.
using JacobianDeviation = std::array<Row3, 4>;

/// Over all w with |w_j - p_j| <= h_j.
template <class Equations>
JacobianDeviation jacobian_deviation(const Equations& g, std::size_t axis, const std::array<double, 4>& slope,
                                     const std::array<double, 4>& h) {
  using Ball = typename Equations::Number;
  const auto others = other_axes(axis);
  const auto ideal = [&](std::size_t j, std::size_t row) {
    return j == axis ? -slope[others[row]] : (others[row] == j ? 1.0 : 0.0);
  };
  JacobianDeviation linear{};
  JacobianDeviation higher{};
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t row = 0; row < 3; ++row) linear[j][row] = std::fabs(ideal(j, row));
  }
  const MonomialsAt monomials(h);
  g.for_each_term([&](const TermExponents& e, const BallVector<Ball>& c) {
    const std::size_t degree = straight::degree(e);
    if (degree == 1) {
      const std::size_t j = straight::variables(e)[0];
      for (std::size_t row = 0; row < 3; ++row)
        linear[j][row] = (c[row] - Ball(ideal(j, row))).upper_magnitude();
    }
    const Row3 m = degree < 2 ? Row3{} : straight::magnitudes(c);
    if (m == Row3{}) {
      return;
    }
    for (std::size_t j = 0; j < 4; ++j) {
      const double derivative = monomials.derivative(e, j);
      for (std::size_t row = 0; row < 3; ++row) higher[j][row] += m[row] * derivative;
    }
  });
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t row = 0; row < 3; ++row) linear[j][row] = kSlack * (linear[j][row] + higher[j][row]);
  }
  return linear;
}

/// Of the columns other than the axis.
inline Row3 row_sums(const JacobianDeviation& e, std::size_t axis) {
  Row3 sum{};
  for (const std::size_t j : other_axes(axis)) {
    for (std::size_t row = 0; row < 3; ++row) sum[row] += e[j][row];
  }
  return {kSlack * sum[0], kSlack * sum[1], kSlack * sum[2]};
}
inline double largest_of(const Row3& row) { return larger_bound(row[0], row[1], row[2]); }

/// Lemma 5.1 (a), with the largest row sum `contraction` < 1: |w' - d| on the arc. The ideal matrix maps d to
/// 0, so that |G_tau| = |C DPhi d| <= sum_j E_j |d_j|.
inline std::array<double, 4> slope_errors(const JacobianDeviation& e, std::size_t axis,
                                          const std::array<double, 4>& slope, double contraction) {
  const auto others = other_axes(axis);
  Row3 base{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t j = 0; j < 4; ++j) base[row] += e[j][row] * std::fabs(slope[j]);
    base[row] *= kSlack;
  }
  const Row3 bound = tubes::bound_solution(e, others, base, contraction);
  std::array<double, 4> result{};
  for (std::size_t row = 0; row < 3; ++row) result[others[row]] = bound[row];
  return result;
}

/// w'' is within `error` of `middle` on an arc.
struct SecondDerivative {
  std::array<double, 4> middle{};
  std::array<double, 4> error{};
};

/// (6.5), by Lemma 5.1 (a), over the arc where |w_j - p_j| <= h_j and |w' - d| <= error, s = -g''(p)[d,d]
/// about: the right side is |g''(w)[w',w'] + s| + |(M - 1) s|.
template <class Equations>
SecondDerivative second_derivative(const Equations& g, std::size_t axis, const std::array<double, 4>& slope,
                                   const std::array<double, 4>& error, const std::array<double, 4>& h,
                                   const JacobianDeviation& e, double contraction) {
  using Ball = typename Equations::Number;
  const auto others = other_axes(axis);
  std::array<double, 4> steepest{};
  for (std::size_t j = 0; j < 4; ++j) steepest[j] = std::fabs(slope[j]) + error[j];
  const MonomialsAt monomials(h);
  BallVector<Ball> form;
  Row3 base{};
  g.for_each_term([&](const TermExponents& exponents, const BallVector<Ball>& c) {
    const std::size_t degree = straight::degree(exponents);
    const Row3 m = degree < 2 ? Row3{} : straight::magnitudes(c);
    if (m == Row3{}) {
      return;
    }
    double change = 0;
    if (degree == 2) {
      const auto [i, j] = straight::variables(exponents);
      const Ball at_centre = Ball(2 * slope[i]) * Ball(slope[j]);
      for (std::size_t row = 0; row < 3; ++row) form[row] += at_centre * c[row];
      change = 2 * (steepest[i] * error[j] + std::fabs(slope[j]) * error[i]);
    } else {
      change = monomials.second(exponents, steepest);
    }
    for (std::size_t row = 0; row < 3; ++row) base[row] += m[row] * change;
  });
  SecondDerivative result;
  for (std::size_t row = 0; row < 3; ++row) {
    const double s = -form[row].approximation();
    result.middle[others[row]] = s;
    base[row] += (form[row] + Ball(s)).upper_magnitude();
  }
  for (std::size_t row = 0; row < 3; ++row) {
    for (const std::size_t j : others) base[row] += e[j][row] * std::fabs(result.middle[j]);
    base[row] *= kSlack;
  }
  const Row3 bound = tubes::bound_solution(e, others, base, contraction);
  for (std::size_t row = 0; row < 3; ++row) result.error[others[row]] = bound[row];
  return result;
}

}  // namespace exsect
