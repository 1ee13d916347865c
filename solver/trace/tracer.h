// Follows the intersection curve of a pair by overlapping tubes. Internal to solver/.
#pragma once

#include <variant>
#include <vector>

#include "answer/stop_request.h"
#include "trace/tube.h"
#include "trace/tube_trace.h"

namespace exsect {

template <class Ball>
using Piece = TubePiece<Tube<Ball>>;
template <class Ball>
using Trace = TubeTrace<Tube<Ball>>;

/// From landmark `start` in the direction sign * T (sign +1 or -1) to the first other landmark met.
template <class Ball>
std::variant<Trace<Ball>, TraceFailure> trace_arc(const PairSystem<Ball>& system,
                                                  const Landmarks<Ball>& landmarks, int start, int sign,
                                                  const StopRequest& stop);

/// The closed curve through the curve point in `seed`, which must meet no landmark: meeting one is a failure.
template <class Ball>
std::variant<Trace<Ball>, TraceFailure> trace_loop(const PairSystem<Ball>& system,
                                                   const Landmarks<Ball>& landmarks,
                                                   const BallPoint<Ball>& seed, const StopRequest& stop);

/// True only if the curve point known to lie in the box is on the trace, or behind an end of it but in a box
/// that is not told apart from that end.
template <class Ball>
bool passes_through(const Trace<Ball>& trace, const BallPoint<Ball>& box);

}  // namespace exsect
