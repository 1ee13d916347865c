// From the curves of a self-intersection to nodes and arcs. Internal to solver/.
#pragma once

#include "self/curves.h"

namespace exsect {

/// Appends nodes and arcs of all curves; `ends`: what the landmarks of `found` lead to. Arcs follow
/// each other along each curve. Turning points with respect to `wanted` become nodes, polylines keep within
/// `tolerance` (space units) of the curve where doubles can express that; Arc::error_bound is what is proved.
template <class Ball>
void append_self_curves(GraphBuilder& graph, const SelfSystem<Ball>& system, const SelfCurves<Ball>& found,
                        const std::vector<TraceEnd>& ends, const ModelFrame& frame,
                        const std::vector<Parameter>& wanted, double tolerance);

/// The node of a cuspidal point.
template <class Ball>
Node cusp_node(const ChartSystem<Ball>& system, const CuspArc<Ball>& arc, const ModelFrame& frame);

/// The arcs of a trace in the charts, in the order of its pairs or exchanged, from node `start` to node `end`
/// (-1: a gate); its turning points become nodes as above.
template <class Ball>
std::vector<Arc> chart_arcs(GraphBuilder& graph, const SelfSystem<Ball>& system,
                            const ChartTrace<Ball>& trace, bool exchange, const ModelFrame& frame,
                            const std::vector<Parameter>& wanted, double tolerance, int start, int end);

/// The arcs run through in the other direction.
void reverse(std::vector<Arc>& arcs);

/// Joins two lists of arcs; the last arc of `first` and the first of `second` meet at a gate and become one.
std::vector<Arc> joined(std::vector<Arc> first, std::vector<Arc> second);

}  // namespace exsect
