// Tracing the curve with certified tubes. Internal to solver/; docs/method.md, section 14.3.
#pragma once

#include <vector>

#include "filter/boundary.h"
#include "trace/piece_range.h"

namespace exsect::filter {

/// The part of a tube's arc that is used, in the direction of the trace.
struct Piece {
  Tube tube;
  PieceRange range;
};

/// Consecutive pieces end and begin in the same point of the curve. `start` and `end` are indices of boundary
/// points, or -1 for a closed curve, whose last piece ends where the first one begins.
struct Trace {
  std::vector<Piece> pieces;
  int start;
  int end;
};

/// From a boundary point into the domain, to the next boundary point; empty if undecided: then `stuck`, if
/// given, is where it got to.
std::optional<Trace> trace_arc(const Pair& pair, const std::vector<BoundaryPoint>& points, std::size_t start,
                               Vec4* stuck = nullptr);

/// The closed curve through the solution on the tube's arc at tau; empty if undecided, in particular if it
/// meets a boundary point.
std::optional<Trace> trace_loop(const Pair& pair, const std::vector<BoundaryPoint>& points, const Tube& tube,
                                double tau);

}  // namespace exsect::filter
