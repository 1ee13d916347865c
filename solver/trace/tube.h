// Certifying Krawczyk tubes (tube_type.h), and points and derivatives of the curve on them. Internal to
// solver/; docs/method.md, section 5.
#pragma once

#include <cmath>
#include <optional>

#include "trace/tube_type.h"

namespace exsect {

/// The coordinate with the largest component, about.
template <class Ball>
std::size_t steepest_axis(const BallPoint<Ball>& tangent) {
  std::size_t axis = 0;
  for (std::size_t j = 1; j < 4; ++j) {
    if (std::fabs(tangent[j].approximation()) > std::fabs(tangent[axis].approximation())) {
      axis = j;
    }
  }
  return axis;
}

/// T at a point.
template <class Ball>
BallPoint<Ball> tangent_at(const PairSystem<Ball>& system, const BallPoint<Ball>& p) {
  return Expansion<Ball>(system, p).tangent();
}

/// The tube around `centre` (its midpoints are used) over tau in [-reach, reach], half widths at least
/// `least_halfwidth`; empty if it cannot be proved with these numbers.
template <class Ball>
std::optional<Tube<Ball>> certify_tube(const PairSystem<Ball>& system, const BallPoint<Ball>& centre,
                                       std::size_t axis, double reach, double least_halfwidth);

/// The largest of the reaches most, most / 2, most / 4, ..., at least about `least`, for which the tube
/// around `centre` is proved with the half widths given, if longer ones are harder to prove; 0 if there is
/// none.
template <class Ball>
double largest_reach(const PairSystem<Ball>& system, const BallPoint<Ball>& centre, std::size_t axis,
                     double least, double most, double least_halfwidth, double worst_contraction);

/// Approximate Newton correction of the coordinates other than `axis` towards F = 0 (an estimate, not a
/// proof); empty if the columns are numerically dependent.
template <class Ball>
std::optional<BallPoint<Ball>> newton_corrected(const PairSystem<Ball>& system, const BallPoint<Ball>& start,
                                                std::size_t axis, int steps);

/// The values of a function on an interval are within `error` of `middle`.
struct ValueRange {
  double middle;
  double error;
  bool has_sign() const { return middle > error || -middle > error; }
};
/// w_i'(tau) and w_i''(tau) for all tau between two offsets, in either order.
template <class Ball>
ValueRange slope_between(const Tube<Ball>& tube, std::size_t i, double from, double to);
template <class Ball>
ValueRange second_between(const Tube<Ball>& tube, std::size_t i, double from, double to);

}  // namespace exsect
