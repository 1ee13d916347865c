// The piece of the self-intersection curve next to a cuspidal point. Internal to solver/.
#pragma once

#include <string>
#include <variant>

#include "graph_builder.h"
#include "self_search.h"

namespace exsect {

/// The curve from a cuspidal point, w = 0, to its gate, w = gate_w: a tube of axis w over [0, gate_w] that
/// stays inside the domain, on which u1, v1, u2 and v2 are monotone.
template <class Ball>
struct CuspArc {
  Chart chart;
  ChartTube<Ball> tube;
  BallPoint<Ball> cusp;  // (U,V,m,0)
  double gate_w;
  BallPoint<Ball> gate;  // (u1,v1,u2,v2) with t > 0
};

/// Empty if the arc cannot be proved: a cuspidal point that is not a regular end of the curve, near a side,
/// or with a null direction near a parameter's own.
template <class Ball>
std::optional<CuspArc<Ball>> cusp_arc(const ChartSystem<Ball>& system, const ChartCusp<Ball>& cusp);

/// True only if the point of the chart `chart`, known to be on the curve, is on the arc's tube.
template <class Ball>
bool passes_through(const CuspArc<Ball>& arc, Chart chart, const BallPoint<Ball>& point);

/// The node of the cuspidal point.
template <class Ball>
Node cusp_node(const ChartSystem<Ball>& system, const CuspArc<Ball>& arc, const ModelFrame& frame);

/// Vertices from the cuspidal point to the gate, and the proved bound of their distance from the arc, at most
/// `tolerance` where doubles can express that.
struct CuspPolyline {
  std::vector<PolylineVertex> vertices;
  double error_bound;
};
template <class Ball>
CuspPolyline cusp_polyline(const ChartSystem<Ball>& system, const CuspArc<Ball>& arc, const ModelFrame& frame,
                           double tolerance);

}  // namespace exsect
