// Traces curves along which the two patches touch by certified tubes. Internal to solver/.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "trace/tangential_tube.h"
#include "trace/tracer.h"

namespace exsect {

/// A part of the curve on one tube.
template <class Ball>
struct TangentialPiece {
  TangentialTube<Ball> tube;
  PieceRange range;
};

/// A connected piece of a curve with F = 0 and tangent field 0: every piece's end point is on the next
/// piece's arc. start and end are indices of landmarks, -1 for a closed curve.
template <class Ball>
struct TangentialArc {
  std::vector<TangentialPiece<Ball>> pieces;
  int start = -1;
  int end = -1;
};

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
