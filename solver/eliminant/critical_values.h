// Critical values of a sweep parameter and rational samples between them.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <vector>

#include "answer/stop_request.h"

namespace exsect {

/// One root of the turning eliminant in [0,1], with its multiplicity there; 0 where that says nothing (some
/// roots, where the patches touch along a curve).
struct TurningValue {
  RealAlgebraic value;
  int multiplicity;
};

/// The turning eliminant of a sweep along one of the four parameters.
struct TurningValues {
  Parameter sweep;
  std::vector<TurningValue> values;  // ascending, distinct
  /// Every fibre has multiple points. Those over other values than these are regular points of curves along
  /// which the patches touch.
  bool touching = false;
};

/// Roots in [0,1] of the turning eliminant of the sweep along `sweep`; empty if it is not defined.
std::optional<TurningValues> turning_values(const BezierPatch& x, const BezierPatch& y, Parameter sweep);

/// Roots in [0,1] of the turning eliminant E of the sweep along u; where E is not defined for this pair, of
/// the sweep along v, r or s; one along which not every fibre has multiple points is preferred, then one with
/// few turning values without a multiplicity, then one with few values over which there may be a line that
/// lies on the other patch. Every closed component of the intersection has at least two of them as extreme
/// values of the sweep parameter. Empty optional if none of the four is defined, or none before `stop`; `why`
/// then says why. `tried`: turning_values of the sweeps that were looked at, by parameter.
struct SweepChoice {
  std::optional<TurningValues> turning;
  std::string why;
  std::array<std::optional<std::optional<TurningValues>>, 4> tried;
};
SweepChoice choose_sweep(const BezierPatch& x, const BezierPatch& y, const StopRequest& stop = {});

/// Rational samples in (0,1), ascending, one strictly between any two neighbouring critical values: the
/// turning values and the boundary points' values of the sweep parameter. Boundary values that overlap each
/// other or a turning value within 2^-50 need no sample between them; two turning values always get one. Also
/// refines the turning values so far that their intervals contain no sample and are disjoint.
std::vector<Rational> sweep_samples(TurningValues& turning, const std::vector<CertifiedPoint>& boundary);

}  // namespace exsect
