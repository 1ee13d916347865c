// Traces curves along which the two patches touch by certified tubes. Internal to solver/.
#pragma once

#include <variant>

#include "answer/stop_request.h"
#include "trace/tangential_tube.h"
#include "trace/tube_trace.h"

namespace exsect {

template <class Ball>
using TangentialPiece = TubePiece<TangentialTube<Ball>>;
/// Of a connected piece of a curve with F = 0 and tangent field 0.
template <class Ball>
using TangentialArc = TubeTrace<TangentialTube<Ball>>;

/// The curve through the point in `seed` on which F and the tangent field are known to vanish, in both
/// directions to the first landmarks. Everything follows from that: two analytic arcs that agree near a point
/// agree.
template <class Ball>
std::variant<TangentialArc<Ball>, TraceFailure> trace_contact(const PairSystem<Ball>& system,
                                                              const Landmarks<Ball>& landmarks,
                                                              const BallPoint<Ball>& seed,
                                                              const StopRequest& stop);

/// True only if every solution in the box is on the arc, and on this part of it.
template <class Ball>
bool passes_through(const TangentialArc<Ball>& arc, const BallPoint<Ball>& box);

/// The tangent direction's component at the arc's start (index 0) or end (1) in parameter j has a sign for
/// certain: +1 or -1 when the arc is run through from start to end; 0: not known.
template <class Ball>
int certain_direction(const PairSystem<Ball>& system, const TangentialArc<Ball>& arc, int which,
                      std::size_t j);

}  // namespace exsect
