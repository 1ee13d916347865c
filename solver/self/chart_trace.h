// The self-intersection curve followed in the charts, from a cuspidal point through the pairs of neighbouring
// parameters. Internal to solver/.
#pragma once

#include <vector>

#include "answer/stop_request.h"
#include "self/cusp_arc.h"
#include "trace/turning_points.h"

namespace exsect {

/// Both charts of one patch.
template <class Ball>
using Charts = std::array<ChartSystem<Ball>, 2>;

template <class Ball>
const ChartSystem<Ball>& chart_of(const Charts<Ball>& charts, Chart c) {
  return charts[c == Chart::first ? 0 : 1];
}

/// A part of the curve on one tube. The order of the pairs is that of t > 0 in the piece's chart, or the
/// other one.
template <class Ball>
struct ChartPiece {
  Chart chart;
  bool exchanged;
  bool monotone;  // u1, v1, u2, v2 are known to be monotone or constant
  ChartTube<Ball> tube;
  PieceRange range;
};

/// The pair (u1,v1,u2,v2) of a point of the piece's chart with w > 0.
template <class Ball>
BallPoint<Ball> pair_on(const ChartPiece<Ball>& piece, const BallPoint<Ball>& p) {
  const BallPoint<Ball> pair = pair_of(piece.chart, p);
  return piece.exchanged ? exchanged_pair(pair) : pair;
}

/// A connected piece of the curve that starts in a cuspidal point and stays in the interior of the domain:
/// every piece's end point is proved to lie on the next piece's arc. It ends in another cuspidal point or at
/// a gate.
template <class Ball>
struct ChartTrace {
  std::vector<ChartPiece<Ball>> pieces;
  TurningPoints<Ball> turning;  // their boxes are in the charts
  std::vector<TraceCut> cuts = {};
  int start;                     // index of the cuspidal point
  int end = -1;                  // of the other one; -1: the gate
  BallPoint<Ball> gate;          // (u1,v1,u2,v2)
  std::array<int, 4> direction;  // signs of u1', v1', u2', v2' at the gate along the trace, 0 if unknown
};

/// Follows the curve from cusps[start] until the pairs are well apart, near the boundary of the domain, or
/// another cuspidal point is reached, or it must stop.
template <class Ball>
ChartTrace<Ball> trace_from_cusp(const Charts<Ball>& charts, const std::vector<CuspArc<Ball>>& cusps,
                                 int start, const StopRequest& stop);

/// True only if the point of the chart `chart`, known to be on the curve, is on the trace.
template <class Ball>
bool passes_through(const ChartTrace<Ball>& trace, Chart chart, const BallPoint<Ball>& point);

}  // namespace exsect
