// A tube that contains a box of a search, so that at most one arc of the curve passes through it. Internal to
// solver/; docs/method.md, section 5.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "trace/breadth_first.h"
#include "trace/tube.h"

namespace exsect {

/// The box as balls.
template <class Ball>
BallPoint<Ball> ball_box(const SearchRegion& box) {
  BallPoint<Ball> result;
  for (std::size_t j = 0; j < 4; ++j) {
    const double half = 0.5 * (box.upper[j] - box.lower[j]) * kSlack;
    result[j] = (Ball(0.5) * (Ball(box.lower[j]) + Ball(box.upper[j]))).widened(half);
  }
  return result;
}

/// Along the given axis, or the steepest one at the middle of the box; empty if it is not proved, and if the
/// curve is found farther from the box than `farthest` times its size, by which it is not worth a proof. A
/// System has tangent_at, newton_corrected and certify_tube.
template <template <class> class System, class Ball>
auto covering_tube(const System<Ball>& system, const SearchRegion& box,
                   std::optional<std::size_t> wanted_axis, double farthest)
    -> decltype(certify_tube(system, BallPoint<Ball>(), 0, 0, 0)) {
  BallPoint<Ball> centre;
  std::array<double, 4> half{};
  for (std::size_t j = 0; j < 4; ++j) {
    centre[j] = Ball(0.5 * (box.lower[j] + box.upper[j]));
    half[j] = 0.5 * (box.upper[j] - box.lower[j]) * kSlack;
  }
  const BallPoint<Ball> tangent = tangent_at(system, centre);
  const std::size_t axis = wanted_axis.value_or(steepest_axis(tangent));
  const auto start = newton_corrected(system, centre, axis, 3);
  if (!start) return std::nullopt;
  double needed = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    const double distance = ((*start)[j] - centre[j]).upper_magnitude();
    const double rise = std::fabs(tangent[j].approximation() / tangent[axis].approximation()) * half[axis];
    if (distance > farthest * (half[j] + rise)) return std::nullopt;
    if (j != axis) needed = std::max(needed, distance + half[j] + 1.01 * rise);
  }
  const double reach = std::max(half[axis] * 1.01, 0x1p-30 * needed);
  auto tube = certify_tube(system, *start, axis, reach, needed * 1.01);
  return tube && contains(*tube, ball_box<Ball>(box)) ? std::move(tube) : std::nullopt;
}

/// One of three points of the tube's arc is `known`.
template <class Tube, class IsKnown>
bool is_arc_known(const Tube& tube, const IsKnown& is_known) {
  return std::ranges::any_of(std::array{0.0, -tube.reach, tube.reach},
                             [&](double tau) { return is_known(point_at(tube, tau)); });
}

}  // namespace exsect
