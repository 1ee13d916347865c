// All curves where a patch meets itself, traced from boundary points, cuspidal points and searches, with the
// proof that none is missing. Internal to solver/.
#pragma once

#include "self/loops.h"
#include "self/places.h"
#include "trace/trace_graph.h"

namespace exsect {

/// If no problem is reported, the curves, their pieces next to the cuspidal points and the isolated points
/// and exact.folds are all pairs u1,v1 != u2,v2 with x(u1,v1) = x(u2,v2) in the squares, and no other curve
/// ends in a cuspidal point. `width`: of the boxes around exact points. Precondition: exact.boundary.problems
/// is empty. `charts`: the patch in doubles, for searches, which
/// `effort` bounds.
template <class Ball>
SelfCurves<Ball> trace_self_curves(const SelfSystem<Ball>& system, const Charts<DoubleBall>& charts,
                                   const ExactPlaces& exact, const Rational& width, SearchEffort effort,
                                   const StopRequest& stop);

/// True if a short search proves that the patch does not meet itself and has no cuspidal point.
bool is_quickly_injective(const SelfSystem<DoubleBall>& system, const StopRequest& stop);

}  // namespace exsect
