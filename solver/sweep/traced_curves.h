// All curves of the intersection, traced from boundary points, fibres and searches, with the proof that none
// is missing. Internal to solver/.
#pragma once

#include <algorithm>
#include <vector>

#include "sweep/sweep_data.h"
#include "trace/contact_graph.h"
#include "trace/trace_graph.h"

namespace exsect {

/// The curves traced in one arithmetic, and what it could not decide.
template <class Ball>
struct TracedCurves {
  std::vector<AnalysedTrace<Ball>> curves;
  std::vector<AnalysedContact<Ball>> contacts;  // curves along which the patches touch
  std::vector<int> isolated;                    // boundary points at which no curve enters the domain
  std::vector<Incomplete> problems;
  long searched_boxes = 0;
  bool cut_short = false;  // a problem is left because of SweepData::quick
};

/// How many of the curves pass through a box.
template <class Ball>
int curves_through(const TracedCurves<Ball>& traced, const BallPoint<Ball>& box) {
  return static_cast<int>(
      std::count_if(traced.curves.begin(), traced.curves.end(),
                    [&](const AnalysedTrace<Ball>& curve) { return passes_through(curve.trace, box); }));
}
template <class Ball>
int contacts_through(const TracedCurves<Ball>& traced, const BallPoint<Ball>& box) {
  return static_cast<int>(std::count_if(
      traced.contacts.begin(), traced.contacts.end(),
      [&](const AnalysedContact<Ball>& contact) { return passes_through(contact.trace, box); }));
}

/// Traces every curve. `landmarks` are sweep.landmarks enclosed in boxes of width at most `width`. If no
/// problem is reported, the curves and isolated points are the whole intersection (provided `sweep.exact`):
/// every arc with ends starts at a boundary point or a star; closed curves meet a fibre (or are found by
/// search_closed_curves where there is no eliminant); curves along which the patches touch meet a fibre too,
/// or are parameter lines; and at every sample the traced curves and the exact fibre are in bijection.
template <class Ball>
TracedCurves<Ball> trace_curves(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                                const SweepData& sweep, const Rational& width, const StopRequest& stop);

}  // namespace exsect
