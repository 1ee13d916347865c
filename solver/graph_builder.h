// From traced curves to nodes, arcs with polylines, and components. Internal to solver/.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include <vector>

#include "turning_points.h"

namespace exsect {

/// The translation and scaling of PairSystem: a space point is origin + 2^exponent * (scaled point). The
/// origin has double coordinates.
struct ModelFrame {
  std::array<double, 3> origin;
  long exponent;
};

/// A traced curve with all its turning points, in order.
template <class Ball>
struct AnalysedTrace {
  Trace<Ball> trace;
  std::vector<TurningPoint<Ball>> turning;
};

/// The node of a boundary point; `box` encloses its parameters.
template <class Ball>
Node boundary_node(const PairSystem<Ball>& system, const ModelFrame& frame, const BallPoint<Ball>& ball,
                   const ParameterBox& box, const std::vector<Side>& sides);

/// Appends the arcs of one trace and its turning nodes with respect to `wanted` parameters (a closed curve
/// without any gets all its turning nodes). Nodes 0..n-1 of the graph are the landmarks. Polylines keep
/// within `tolerance` (space units) of the curve where doubles can express that; Arc::error_bound is what is
/// proved.
template <class Ball>
void append_trace(IntersectionGraph& graph, const AnalysedTrace<Ball>& curve, const ModelFrame& frame,
                  const std::vector<Parameter>& wanted, double tolerance);

/// Fills in components from nodes and arcs, and drops the nodes that no arc, no isolated point and no
/// overlap names.
void finish_components(IntersectionGraph& graph);

}  // namespace exsect
