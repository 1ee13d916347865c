// The piece of the self-intersection curve next to a cuspidal point. Internal to solver/.
#pragma once

#include <optional>

#include "self/search.h"
#include "shape/special_cusps.h"

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
/// stays inside the domain, on which u1, v1, u2 and v2 are monotone or constant; or one that leaves the
/// domain.
template <class Ball>
struct CuspArc {
  Chart chart;
  CuspPlace place;
  /// For U and V: +1 or -1 if the coordinate is on a side at the cuspidal point, and that of (U + t, V + m t)
  /// lies above or below this value for all w > 0, that of (U - t, V - m t) on the other side of it. Else 0.
  std::array<int, 2> across;
  ChartTube<Ball> tube;
  BallPoint<Ball> cusp;  // (U,V,m,0)
  double gate_w;

  /// No pair with w > 0 is in the domain.
  bool leaves() const { return across[0] != 0 || across[1] != 0; }
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
