// The certified tracer: follows the intersection curve by overlapping tubes. Internal to solver/.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "answer/stop_request.h"
#include "trace/piece_range.h"
#include "trace/tube.h"

namespace exsect {

/// A part of the curve on one tube.
template <class Ball>
struct Piece {
  Tube<Ball> tube;
  PieceRange range;
};

/// A connected piece of the curve: every piece's end point is proved to lie on the next piece's arc. start
/// and end are indices of landmarks, -1 for a closed curve, whose last point is its first.
template <class Ball>
struct Trace {
  std::vector<Piece<Ball>> pieces;
  int start = -1;
  int end = -1;
  std::array<BallPoint<Ball>, 2> ends = {};  // the boxes of these landmarks
};

/// A place on a trace, known as a landmark, where its arcs are cut: piece, and offset within `radius`.
struct TraceCut {
  int landmark;
  std::size_t piece;
  double tau;
  double radius;
};

/// Why a trace stopped without a result, and about where.
struct TraceFailure {
  std::array<double, 4> where;
  std::string why;
};

/// What a trace may meet: every intersection point on a side of the two parameter squares, each in a small
/// box.
template <class Ball>
using Landmarks = std::vector<BallPoint<Ball>>;

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
