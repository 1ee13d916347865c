// Tracing the curve with certified tubes. Internal to solver/; docs/method-doubles.md, section 14.3.
#pragma once

#include <vector>

#include "filter/boundary.h"
#include "trace/tube_trace.h"

namespace exsect::filter {

/// The part of a tube's arc that is used, in the direction of the trace.
template <class K>
using PieceOf = TubePiece<TubeOf<K>>;
using Piece = PieceOf<Biquadratic>;

/// Consecutive pieces end and begin in the same point of the curve. `start` and `end` are indices of boundary
/// points, or -1 for a closed curve, whose last piece ends where the first one begins.
template <class K>
using TraceOf = TubeTrace<TubeOf<K>, BallOf<K>>;
using Trace = TraceOf<Biquadratic>;

/// From a boundary point into the domain, to the next boundary point; empty if undecided: then `stuck`, if
/// given, is where it got to.
template <class K>
std::optional<TraceOf<K>> trace_arc(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
                                    std::size_t start, Vec4* stuck);
template <class K>
std::optional<TraceOf<K>> trace_arc(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
                                    std::size_t start) {
  return trace_arc<K>(pair, points, start, nullptr);
}

/// The closed curve through the solution on the tube's arc at tau; empty if undecided, in particular if it
/// meets a boundary point.
template <class K>
std::optional<TraceOf<K>> trace_loop(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
                                     const TubeOf<K>& tube, double tau);

}  // namespace exsect::filter
