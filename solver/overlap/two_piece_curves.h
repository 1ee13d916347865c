// The curves in which two pieces of one polynomial surface meet apart from the region they share. Internal to
// solver/; docs/method.md, section 6.3.
#pragma once

#include <exsect/solver/result.h>

#include "answer/graph_builder.h"
#include "self/curves.h"
#include "shape/shifted_copy.h"

namespace exsect {

/// y(r,s) = x(maps[0](r), maps[1](s)), and where the two pieces lie.
struct TwoPieces {
  BezierPatch x;
  BezierPatch y;
  ShiftedCopy copy;
  std::array<AffineMap, 2> common;  // from [0,1]² to the rectangle of (u,v) that both pieces cover
  std::array<AffineMap, 2> hull;    // from [0,1]² to the smallest rectangle that contains both pieces
  bool overlapping;                 // the common rectangle has inner points; else `common` says nothing

  /// x over the common rectangle.
  BezierPatch shared() const;
};

/// Empty if y is no such piece.
std::optional<TwoPieces> two_pieces(const BezierPatch& x, const BezierPatch& y);

/// A point of a chart of the hull's rectangle in the same chart of the common one (where |m| may exceed 1).
template <class Ball>
BallPoint<Ball> in_common(const TwoPieces& pieces, Chart chart, const BallPoint<Ball>& p);

/// All pairs x(u,v) = y(r,s) of different points of the common surface. `landmarks` are the boundary points,
/// then two for each gate, as in SelfCurves, where `near` (of the shared patch, without curves) leads to its
/// cuspidal points, then some on arcs of sides. A cuspidal point lies in the inside of the region that both
/// pieces cover; both orders of a curve end there.
template <class Ball>
struct TwoPieceCurves {
  Landmarks<Ball> landmarks;
  std::size_t boundary_points = 0;
  std::vector<AnalysedTrace<Ball>> curves;
  std::vector<bool> along_side;  // per curve: it runs along a folded side, where the arcs are known exactly
  std::vector<int> isolated;     // boundary points at which no curve enters the domain
  SelfCurves<Ball> near;
  std::vector<Incomplete> problems;
  long searched_boxes = 0;
};

/// The curves, with the proof that there are no others if no problem is reported. `boundary`: the points on
/// sides that are not on an arc of a side; `side_ends`: the ends of arcs of sides on which the patches cross.
/// `width`: of the boxes around exact points.
template <class Ball>
TwoPieceCurves<Ball> trace_two_pieces(const TwoPieces& pieces, const SelfSystem<Ball>& shared,
                                      const PairSystem<Ball>& system,
                                      const std::vector<CertifiedPoint>& boundary,
                                      const std::vector<CertifiedPoint>& side_ends, const Point& origin,
                                      long exponent, const Rational& width, const StopRequest& stop);

}  // namespace exsect
