#include "trace/tangential_enclosure.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trace/contact_jacobian.h"

namespace exsect {

namespace {

/// The equations around the middle of a part of an arc, and what is known of w' on it: |w' - slope| <= error
/// in the coordinates other than the axis.
template <class Ball>
class LocalPart {
 public:
  // With C and d made for the middle of the part, |C DPhi - (I, -d)| <= E on a box around it that holds the
  // part. The exact w' has 0 = C Phi'(w) w' = C Phi'(w) d + M (w' - d) with |M - I| <= sigma, the greatest
  // row sum of E without the axis, and |C Phi'(w) d| <= sum_j E_j |d_j|: |w' - d| <= sum_j E_j |d_j| / (1 -
  // sigma).
  LocalPart(const PairSystem<Ball>& system, const TangentialTube<Ball>& tube, double from, double to)
      : axis_(tube.axis),
        half_(0.5 * std::fabs(to - from) * kSlack),
        middle_(point_at(system, tube, 0.5 * (from + to))),
        slope_(tube.slope),
        error_(tube.slope_error) {
    BallPoint<Ball> centre;
    for (std::size_t j = 0; j < 4; ++j) {
      centre[j] = middle_[j].midpoint();
      radius_ = larger_bound(radius_, (middle_[j] - centre[j]).upper_magnitude());
    }
    const auto phi = contact_equations(Expansion<Ball>(system, centre), tube.rows, axis_);
    const Linearisation local =
        linearised(phi, axis_).value_or(Linearisation{axis_, tube.preconditioner, tube.slope});
    ideal_ = local.slope;
    g_ = preconditioned(local.preconditioner, phi);
    for (int i = 0; i < 3; ++i) {
      const JacobianDeviation e = jacobian_deviation(g_, axis_, ideal_, widths());
      const double sigma = largest_row_sum(e, axis_);
      const double bound = kSlack * direction_residual(e, ideal_) / (1 - sigma);
      if (!(sigma < 1) || !(bound < error_)) {
        break;
      }
      slope_ = ideal_;
      error_ = bound;
    }
  }

  ArcEnclosure<Ball> enclosure() const {
    ArcEnclosure<Ball> result;
    for (std::size_t j = 0; j < 4; ++j) {
      result.at[j] = middle_[j].widened(half_ * largest_slope(j) * kSlack);
      result.slope[j] = j == axis_ ? Ball(1) : Ball(slope_[j]).widened(error_);
    }
    return result;
  }

  // (6.5): with the quadratic form q(w,d) = C Phi''(w)[d,d], d = `slope` and s = -q(p,d), M (w'' - s) =
  // q(p,d) - q(w,w') - (M - I) s, so that |w'' - s| <= max (|q(w,w') - q(p,d)| + sum_j E_j |s_j|) / (1 -
  // sigma), the largest over the rows.
  std::optional<BallPoint<Ball>> second_derivative() const {
    const JacobianDeviation e = jacobian_deviation(g_, axis_, ideal_, widths());
    const double sigma = largest_row_sum(e, axis_);
    if (!(sigma < 1)) return std::nullopt;
    const auto others = other_axes(axis_);
    BallPoint<Ball> result;
    for (std::size_t row = 0; row < 3; ++row) result[others[row]] = -form_at_centre(row);
    double largest = 0;
    for (std::size_t row = 0; row < 3; ++row) {
      double sum = form_deviation(row);
      for (const std::size_t j : others) sum += e[row][j] * result[j].upper_magnitude();
      largest = larger_bound(largest, sum);
    }
    for (const std::size_t j : others) result[j] = result[j].widened(kSlack * largest / (1 - sigma));
    return result;
  }

 private:
  /// Bounds of |w_j'| and, over the part, of |w_j - p_j|.
  double largest_slope(std::size_t j) const { return std::fabs(slope_[j]) + (j == axis_ ? 0 : error_); }
  std::array<double, 4> widths() const {
    std::array<double, 4> h{};
    for (std::size_t j = 0; j < 4; ++j) h[j] = kSlack * (half_ * largest_slope(j) + radius_);
    return h;
  }

  static bool is_quadratic(const std::array<std::size_t, 4>& e) { return e[0] + e[1] + e[2] + e[3] == 2; }
  /// The two variables of a quadratic term.
  std::array<std::size_t, 2> factors(const std::array<std::size_t, 4>& e) const {
    const auto variables = contact_variables(axis_);
    std::array<std::size_t, 2> result{};
    std::size_t n = 0;
    for (std::size_t v = 0; v < 4; ++v)
      for (std::size_t i = 0; i < e[v]; ++i) result[n++] = variables[v];
    return result;
  }

  Ball form_at_centre(std::size_t row) const {
    Ball sum;
    for_each_term([&](std::size_t t, const std::array<std::size_t, 4>& e) {
      if (!is_quadratic(e)) return;
      const auto [a, b] = factors(e);
      sum += Ball(2 * slope_[a]) * Ball(slope_[b]) * g_[row].c[t];
    });
    return sum;
  }

  /// |q(w,w') - q(p,d)|. The second derivative of a monomial along a line is twice the coefficient of t² of
  /// prod (h + t m)^e, h and m bounds of the offsets and of |w'|.
  double form_deviation(std::size_t row) const {
    const auto variables = contact_variables(axis_);
    const std::array<double, 4> h = widths();
    double sum = 0;
    for_each_term([&](std::size_t t, const std::array<std::size_t, 4>& e) {
      const double c = e[0] + e[1] + e[2] + e[3] < 2 ? 0 : g_[row].c[t].upper_magnitude();
      if (c == 0) return;
      if (is_quadratic(e)) {
        const auto [a, b] = factors(e);
        sum +=
            2 * c *
            (largest_slope(a) * (b == axis_ ? 0 : error_) + std::fabs(slope_[b]) * (a == axis_ ? 0 : error_));
        return;
      }
      std::array<double, 3> product = {1, 0, 0};
      for (std::size_t v = 0; v < 4; ++v) {
        const double m = largest_slope(variables[v]);
        for (std::size_t i = 0; i < e[v]; ++i) {
          product[2] = product[2] * h[variables[v]] + product[1] * m;
          product[1] = product[1] * h[variables[v]] + product[0] * m;
          product[0] *= h[variables[v]];
        }
      }
      sum += 2 * c * product[2];
    });
    return kSlack * sum;
  }

  std::size_t axis_;
  double half_;
  BallPoint<Ball> middle_;
  double radius_ = 0;
  std::array<double, 4> ideal_;
  ContactEquations<Ball> g_;
  std::array<double, 4> slope_;
  double error_;
};

}  // namespace

template <class Ball>
ArcEnclosure<Ball> enclosure_between(const PairSystem<Ball>& system, const TangentialTube<Ball>& tube,
                                     double from, double to) {
  return LocalPart<Ball>(system, tube, from, to).enclosure();
}

template <class Ball>
double second_derivative_bound(const PairSystem<Ball>& system, const TangentialTube<Ball>& tube, double from,
                               double to) {
  const LocalPart<Ball> part(system, tube, from, to);
  const auto second = part.second_derivative();
  if (!second) return std::numeric_limits<double>::infinity();
  const auto [at, slope] = part.enclosure();
  const TaylorNet<Ball> x = system.taylor_x(at);
  std::array<double, 3> bound{};
  for (std::size_t c = 0; c < 3; ++c) {
    const Ball form =
        x[6][c] * slope[0] * slope[0] + x[4][c] * slope[0] * slope[1] + x[2][c] * slope[1] * slope[1];
    const Ball sum = Ball(2) * form + x[3][c] * (*second)[0] + x[1][c] * (*second)[1];
    bound[c] = sum.upper_magnitude();
  }
  return length_bound(bound[0], bound[1], bound[2]);
}

#define EXSECT_INSTANTIATE_TANGENTIAL(Ball)                                                             \
  template ArcEnclosure<Ball> enclosure_between(const PairSystem<Ball>&, const TangentialTube<Ball>&,   \
                                                double, double);                                        \
  template double second_derivative_bound(const PairSystem<Ball>&, const TangentialTube<Ball>&, double, \
                                          double);

EXSECT_INSTANTIATE_TANGENTIAL(DoubleBall)
EXSECT_INSTANTIATE_TANGENTIAL(DoubleDoubleBall)
EXSECT_INSTANTIATE_TANGENTIAL(ArbBall<256>)
EXSECT_INSTANTIATE_TANGENTIAL(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_TANGENTIAL

}  // namespace exsect
