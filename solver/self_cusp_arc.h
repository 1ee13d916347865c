// The piece of the self-intersection curve next to a cuspidal point. Internal to solver/.
#pragma once

#include <optional>

#include "self_search.h"
#include "special_cusps.h"

namespace exsect {

/// What is known exactly of a cuspidal point.
struct CuspPlace {
  /// m = 0: the curve is the folded line through the point, U, V and m constant (of the chart).
  bool folded = false;
  /// The chart's U and V where they are 0 or 1.
  std::array<std::optional<int>, 2> side;
};

/// What is special about the cuspidal point, exactly; `width`: of the boxes for the comparison.
template <class Ball>
CuspPlace exact_place(const ChartSystem<Ball>& system, const ChartCusp<Ball>& cusp,
                      const SpecialCusps& special, const Rational& width);

/// The curve from a cuspidal point, w = 0, to its gate, w = gate_w: a tube of axis w over [0, gate_w] that
/// stays inside the domain, on which u1, v1, u2 and v2 are monotone or constant. If `leaves`, no point of it
/// with w > 0 is in the domain.
template <class Ball>
struct CuspArc {
  Chart chart;
  CuspPlace place;
  bool leaves;
  ChartTube<Ball> tube;
  BallPoint<Ball> cusp;  // (U,V,m,0)
  double gate_w;
};

/// Empty if the arc cannot be proved: the cuspidal point is nearly in one of the special places, or nearly
/// singular.
template <class Ball>
std::optional<CuspArc<Ball>> cusp_arc(const ChartSystem<Ball>& system, const ChartCusp<Ball>& cusp,
                                      const CuspPlace& place);

/// True only if the point of the chart `chart`, known to be on the curve, is on the arc's tube.
template <class Ball>
bool passes_through(const CuspArc<Ball>& arc, Chart chart, const BallPoint<Ball>& point);

}  // namespace exsect
