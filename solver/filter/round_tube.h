// Tubes around pieces of the curve on a round chart. Internal to solver/; docs/method-equations.md, section
// 17.21.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <cmath>
#include <optional>

#include "filter/round_landmarks.h"

namespace exsect {

/// The places centre + s along the axis, |s| <= reach, and slope s + d along the other coordinate, |d| <=
/// width. Invariant: over each s there is exactly one zero of f among them; these are an arc, along which the
/// derivative by the other coordinate is at least `least` in absolute value and has the sign `sign`.
struct RoundTube {
  const RoundChart* chart;
  RoundPlace centre;
  std::size_t axis;
  double slope;
  double reach;
  double width;
  double least;
  int sign;
  double gradient;     // about that derivative in the centre
  double contraction;  // of its quotient by that from 1
  double steep;        // a bound of the derivative of the other coordinate by s along the arc
  double speed;        // of that of the position by the other coordinate
  double rate;         // of that by s along the arc
};

/// About a place near the curve. Empty if there is no proof.
std::optional<RoundTube> round_tube(const RoundChart& chart, const RoundPlace& centre, std::size_t axis,
                                    double reach);

/// s of all places in a box.
DoubleBall offset(const RoundTube& tube, const RoundBox& box);
/// No place of the box is in the tube; all are.
bool excludes(const RoundTube& tube, const RoundBox& box);
bool contains(const RoundTube& tube, const RoundBox& box);

/// Above what both coordinates of a place that is moved twice err by.
inline constexpr double kMoveError = 0x1p-45;
/// The place over s and off, the difference of the other coordinate from the centre's, is in the tube, also
/// if both err by kMoveError.
inline bool is_inside(const RoundTube& tube, double s, double off) {
  return (std::fabs(s) + kMoveError) * kSlack <= tube.reach &&
         (std::fabs(off - tube.slope * s) + kMoveError) * kSlack < tube.width;
}

/// A place over the offset s, and a bound of the distance from the zero over that offset, in the other
/// coordinate: as soon as it is at most `wanted`, or as small as doubles make it; infinite if there is none.
/// `guess` is about this coordinate's difference from the centre's, or not used if it is not in the tube.
struct NearCurve {
  RoundPlace place;
  double off;    // the other coordinate's difference from the centre's
  double error;  // >= 0
};
NearCurve near_curve(const RoundTube& tube, double s, double guess, double wanted);

/// The arc over the offsets within `reach` of that of a place near the curve.
struct RoundArc {
  double slope, bend;  // about the derivatives of the other coordinate by s at the place
  // Of the position by s, all along the arc: the second derivative is at most `acceleration`, its part across
  // the tangent at most `normal`, and the first one at least `least_speed`.
  double acceleration, normal, least_speed;
};
RoundArc arc_near(const RoundTube& tube, const NearCurve& near, double reach);

}  // namespace exsect
