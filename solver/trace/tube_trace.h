// A curve as a chain of tubes, of any kind. Internal to solver/.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "trace/pair_system.h"
#include "trace/piece_range.h"

namespace exsect {

/// A part of the curve on one tube.
template <class Tube>
struct TubePiece {
  Tube tube;
  PieceRange range;
};

/// A connected piece of a curve: every piece's end point is proved to lie on the next piece's arc. start and
/// end are indices of landmarks, -1 for a closed curve, whose last point is its first.
template <class Tube, class Box = decltype(Tube::centre)>
struct TubeTrace {
  std::vector<TubePiece<Tube>> pieces = {};
  int start = -1;
  int end = -1;
  std::array<Box, 2> ends = {};  // the boxes of these landmarks
};

/// What a trace may meet: every intersection point on a side of the two parameter squares, each in a small
/// box.
template <class Ball>
using Landmarks = std::vector<BallPoint<Ball>>;

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

}  // namespace exsect
