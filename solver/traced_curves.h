// All curves of the intersection, traced from boundary points, fibres and searches, with the proof that none
// is missing. Internal to solver/.
#pragma once

#include <exsect/solver/certified_point.h>
#include <exsect/solver/result.h>

#include <vector>

#include "critical_values.h"
#include "graph_builder.h"
#include "subdivision.h"

namespace exsect {

/// The exact part of the sweep: what the tracer joins.
struct SweepData {
  std::vector<CertifiedPoint> boundary;             // every intersection point on a side of a square, once
  std::optional<TurningValues> turning;             // empty where no turning eliminant is defined
  std::vector<Rational> samples;                    // of the sweep parameter
  std::vector<std::vector<CertifiedPoint>> fibres;  // exact, one per sample
  std::array<std::size_t, 4> coincident;            // coincident_parameters(x, y)
  SettledRegion settled;                            // what a search may leave out
  bool exact = true;  // false: boundary points or fibres are known not to be complete
};

/// The curves traced in one arithmetic, and what it could not decide.
template <class Ball>
struct TracedCurves {
  std::vector<AnalysedTrace<Ball>> curves;
  std::vector<int> isolated;  // boundary points at which no curve enters the domain
  std::vector<Incomplete> problems;
  long searched_boxes = 0;
};

/// Traces every curve. `landmarks` are the boundary points enclosed in boxes of width at most `width`. If no
/// problem is reported, the curves and isolated points are the whole intersection (provided `sweep.exact`):
/// every arc with ends starts at a boundary point; closed curves meet a fibre (or are found by
/// search_closed_curves where there is no eliminant); and at every sample the traced curves and the exact
/// fibre are in bijection. Throws std::logic_error if they are not.
template <class Ball>
TracedCurves<Ball> trace_curves(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                                const SweepData& sweep, const Rational& width, const StopRequest& stop);

/// The point's box at `width` as balls.
template <class Ball>
BallPoint<Ball> enclose(const CertifiedPoint& point, const Rational& width);

/// [0,1]^4.
ParameterBox whole_domain();

}  // namespace exsect
