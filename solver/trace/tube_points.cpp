#include "trace/tube_points.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "trace/tube_evaluation.h"

namespace exsect {

using namespace tubes;

namespace {

/// Seen from doubles alone, most boxes are so far along the axis that nothing has to be computed.
template <class Ball>
bool is_far_along(const Tube<Ball>& tube, const BallPoint<Ball>& box) {
  const double distance = box[tube.axis].approximation() - tube.centre[tube.axis].approximation();
  return std::fabs(distance) > 2 * tube.reach + 0x1p-40;
}

}  // namespace

template <class Ball>
BallPoint<Ball> point_at(const Tube<Ball>& tube, double tau, double enough) {
  const auto others = other_axes(tube.axis);
  const Ball sigma(tau / tube.scale);
  BallPoint<Ball> o;
  o[tube.axis] = Ball(tau);
  for (const std::size_t j : others) {
    o[j] = on_line(tube, j, sigma).midpoint();
  }
  // |w - w*| <= |C F(w)| + E |w - w*| for any w in the region; iterate w - C F(w) while that shrinks.
  const BallMatrix<Ball> c = preconditioner_at(tube, sigma);
  const auto [best_offset, residual] = contracted<Ball>(
      o, tube.axis, [&](const BallPoint<Ball>& at) { return premultiplied_value(tube, c, at); }, enough);
  const Row3 radius = bound_solution(tube.deviation, others, residual, tube.contraction);
  bool inside = true;
  for (const std::size_t j : others) {
    const Ball from_line = best_offset[j] - on_line(tube, j, sigma);
    inside = inside && from_line.upper_magnitude() <= tube.halfwidth[j];
  }
  BallPoint<Ball> result;
  result[tube.axis] = tube.centre[tube.axis] + Ball(tau);
  for (std::size_t row = 0; row < 3; ++row) {
    const std::size_t j = others[row];
    // The bound holds in the region only; the region itself is an enclosure.
    result[j] = tube.centre[j] + (inside ? best_offset[j].widened(radius[row])
                                         : on_line(tube, j, sigma).widened(tube.halfwidth[j]));
  }
  return result;
}

template <class Ball>
BallVector<Ball> space_point(const Tube<Ball>& tube, const BallPoint<Ball>& parameters) {
  return value_at(tube.space, parameters[0] - tube.centre[0], parameters[1] - tube.centre[1]);
}

template <class Ball>
Ball offset(const Tube<Ball>& tube, const BallPoint<Ball>& point) {
  return point[tube.axis] - tube.centre[tube.axis];
}

template <class Ball>
bool contains(const Tube<Ball>& tube, const BallPoint<Ball>& box) {
  if (is_far_along(tube, box)) return false;
  const Ball tau = offset(tube, box);
  if (!(tau.upper_magnitude() <= tube.reach)) {
    return false;
  }
  const Ball sigma = tau * Ball(1 / tube.scale);
  for (const std::size_t j : other_axes(tube.axis)) {
    const Ball from_line = box[j] - tube.centre[j] - on_line(tube, j, sigma);
    if (!(from_line.upper_magnitude() <= tube.halfwidth[j])) {
      return false;
    }
  }
  return true;
}

template <class Ball>
bool excludes(const Tube<Ball>& tube, const BallPoint<Ball>& box) {
  const Ball tau = offset(tube, box);
  if (tau.lower_magnitude() > tube.reach) {
    return true;
  }
  const double middle = std::clamp(tau.approximation(), -tube.reach, tube.reach);
  const double spread = (tau - Ball(middle)).upper_magnitude();
  const BallPoint<Ball> w = point_at(tube, middle);
  for (const std::size_t j : other_axes(tube.axis)) {
    const double drift = kSlack * spread * (std::fabs(tube.slope[j]) + tube.slope_error[j]);
    if ((w[j].widened(drift) - box[j]).lower_magnitude() > 0) {
      return true;
    }
  }
  return false;
}

#define EXSECT_INSTANTIATE_POINTS(Ball)                                             \
  template BallPoint<Ball> point_at(const Tube<Ball>&, double, double);             \
  template BallVector<Ball> space_point(const Tube<Ball>&, const BallPoint<Ball>&); \
  template Ball offset(const Tube<Ball>&, const BallPoint<Ball>&);                  \
  template bool contains(const Tube<Ball>&, const BallPoint<Ball>&);                \
  template bool excludes(const Tube<Ball>&, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_POINTS(DoubleBall)
EXSECT_INSTANTIATE_POINTS(DoubleDoubleBall)
EXSECT_INSTANTIATE_POINTS(ArbBall<256>)
EXSECT_INSTANTIATE_POINTS(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_POINTS

}  // namespace exsect
