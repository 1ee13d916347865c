// Krawczyk tubes of the self-intersection curve in a chart of midpoints and half differences, cuspidal points
// included. Internal to solver/.
#pragma once

#include <optional>

#include "self/chart.h"
#include "trace/straight_tube.h"

namespace exsect {

/// Invariant (proved by certify_tube): a straight tube of H = 0.
template <class Ball>
struct ChartTube : StraightTube<Ball> {
  /// z'(tau) lies in slope +- slope_error, z''(tau) in second +- second_error, on all of the tube.
  std::array<double, 4> slope_error;
  std::array<double, 4> second;
  std::array<double, 4> second_error;
  /// C H as Taylor net at p, C near the inverse of the three columns.
  ChartNet<Ball, 2> premultiplied;
};

/// The tube around `centre` (its midpoints are used) over tau in [-reach, reach], half width at least
/// `least_halfwidth`; empty if it cannot be proved with these numbers.
template <class Ball>
std::optional<ChartTube<Ball>> certify_tube(const ChartSystem<Ball>& system, const BallPoint<Ball>& centre,
                                            std::size_t axis, double reach, double least_halfwidth);

/// Approximate Newton correction of the coordinates other than `axis` towards H = 0 (an estimate, not a
/// proof); empty if the columns are numerically dependent.
template <class Ball>
std::optional<BallPoint<Ball>> newton_corrected(const ChartSystem<Ball>& system, const BallPoint<Ball>& start,
                                                std::size_t axis, int steps);

/// An enclosure of the curve's point at tau, |tau| <= reach.
template <class Ball>
BallPoint<Ball> point_at(const ChartTube<Ball>& tube, double tau);

/// True only if the whole box lies in the tube's region: a curve point known to be in the box is then on its
/// arc.
template <class Ball>
bool contains(const ChartTube<Ball>& tube, const BallPoint<Ball>& box);

/// Bound of the Euclidean norm of the second derivative of X along the tube's arc with respect to tau.
template <class Ball>
double space_second_derivative(const ChartSystem<Ball>& system, const ChartTube<Ball>& tube);

/// X(p).
template <class Ball>
BallVector<Ball> space_point(const ChartSystem<Ball>& system, const BallPoint<Ball>& p);

}  // namespace exsect
