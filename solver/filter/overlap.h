// Pieces of one polynomial surface that overlap, in doubles. Internal to solver/; docs/method.md,
// section 14.10.
#pragma once

#include "answer/graph_builder.h"
#include "filter/pieces.h"

namespace exsect::filter {

/// The graph, if y is x in other parameters, each an affine function of one of x, the surface is injective on
/// both squares together, and these have a rectangle in common: that is an overlap and there is nothing else.
/// Empty if that is not so, or not proved, or a polyline cannot keep within `tolerance` (space units).
/// `boxes` counts the pairs looked at.
std::optional<GraphBuilder> overlap_of_pieces(const BezierPatch& x, const BezierPatch& y, const Pair& pair,
                                              Trees& trees, double tolerance, long& boxes);

}  // namespace exsect::filter
