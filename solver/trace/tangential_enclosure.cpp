#include "trace/tangential_enclosure.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trace/contact_expansion.h"

namespace exsect {

namespace {

/// The equations around the middle of a part of an arc, and what is known of w' on it: |w_j' - slope_j| <=
/// error_j.
template <class Ball>
class LocalPart {
 public:
  // With C and d made for the middle of the part, and a box around it that holds the part.
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
        linearised(linear_part(phi), axis_).value_or(Linearisation{axis_, tube.preconditioner, tube.slope});
    ideal_ = local.slope;
    g_ = preconditioned(local.preconditioner, phi);
    for (int i = 0; i < 3; ++i) {
      const JacobianDeviation e = jacobian_deviation(g_, axis_, ideal_, widths());
      const double sigma = largest_of(row_sums(e, axis_));
      if (!(sigma < 1)) break;
      const auto error = slope_errors(e, axis_, ideal_, sigma);
      if (!(largest(error) < largest(error_))) break;
      slope_ = ideal_;
      error_ = error;
    }
  }

  ArcEnclosure<Ball> enclosure() const {
    ArcEnclosure<Ball> result;
    for (std::size_t j = 0; j < 4; ++j) {
      result.at[j] = middle_[j].widened(half_ * largest_slope(j) * kSlack);
      result.slope[j] = j == axis_ ? Ball(1) : Ball(slope_[j]).widened(error_[j]);
    }
    return result;
  }

  std::optional<BallPoint<Ball>> second_derivative() const {
    const JacobianDeviation e = jacobian_deviation(g_, axis_, ideal_, widths());
    const double sigma = largest_of(row_sums(e, axis_));
    if (!(sigma < 1)) return std::nullopt;
    const SecondDerivative second = exsect::second_derivative(g_, axis_, slope_, error_, widths(), e, sigma);
    BallPoint<Ball> result;
    for (std::size_t j = 0; j < 4; ++j) result[j] = Ball(second.middle[j]).widened(second.error[j]);
    return result;
  }

 private:
  static double largest(const std::array<double, 4>& a) { return larger_bound(a[0], a[1], a[2], a[3]); }
  /// Bounds of |w_j'| and, over the part, of |w_j - p_j|.
  double largest_slope(std::size_t j) const { return std::fabs(slope_[j]) + error_[j]; }
  std::array<double, 4> widths() const {
    std::array<double, 4> h{};
    for (std::size_t j = 0; j < 4; ++j) h[j] = kSlack * (half_ * largest_slope(j) + radius_);
    return h;
  }

  std::size_t axis_;
  double half_;
  BallPoint<Ball> middle_;
  double radius_ = 0;
  std::array<double, 4> ideal_;
  ContactEquations<Ball> g_;
  std::array<double, 4> slope_;
  std::array<double, 4> error_;
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
