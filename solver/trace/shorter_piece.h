// Parts of pieces of a trace, on tubes of their own. Internal to solver/.
#pragma once

#include <optional>

#include "trace/tracer.h"

namespace exsect {

/// The range between two points on a tube that contains them and `between`; empty if it is not known to, or
/// if the direction is another one.
template <class Tube, class Point>
std::optional<PieceRange> range_on(const Tube& tube, const Point& start, const Point& between,
                                   const Point& end, int direction) {
  if (!contains(tube, between) || !contains(tube, start) || !contains(tube, end)) return std::nullopt;
  const auto range = PieceRange::between(offset(tube, start), offset(tube, end));
  return range && range->direction() == direction ? range : std::nullopt;
}

/// The part of the piece between two points of it, on a tube around `centre`, a point of the curve between
/// them; empty if that cannot be proved.
template <class Ball>
std::optional<Piece<Ball>> shorter_piece(const PairSystem<Ball>& system, const Piece<Ball>& piece,
                                         const BallPoint<Ball>& start, const BallPoint<Ball>& end,
                                         const BallPoint<Ball>& centre);

/// The part between two offsets.
template <class Ball>
std::optional<Piece<Ball>> shorter_piece(const PairSystem<Ball>& system, const Piece<Ball>& piece,
                                         double from, double to);

/// Gives an arc whose ends can hardly be told apart as offsets a tube of its size, around its middle, if
/// there is one: the step that found its end may have been as long as the patch.
template <class Ball>
void resolve_short_arc(const PairSystem<Ball>& system, Trace<Ball>& trace);

}  // namespace exsect
