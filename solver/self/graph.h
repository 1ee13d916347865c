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

}  // namespace exsect
