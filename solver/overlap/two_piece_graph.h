// The graph of the curves of two pieces of one surface. Internal to solver/.
#pragma once

#include "overlap/two_piece_curves.h"

namespace exsect {

/// Appends the nodes of cuspidal and turning points and all arcs; the boundary points are nodes 0..n-1 of the
/// graph. `wanted`, `tolerance` as in append_trace.
template <class Ball>
void append_two_pieces(GraphBuilder& graph, const TwoPieces& pieces, const SelfSystem<Ball>& shared,
                       const PairSystem<Ball>& system, const TwoPieceCurves<Ball>& found,
                       const ModelFrame& frame, const std::vector<Parameter>& wanted, double tolerance);

}  // namespace exsect
