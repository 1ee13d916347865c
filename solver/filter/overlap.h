// Pieces of one surface that overlap, in doubles. Internal to solver/; docs/method.md, sections 14.10 and
// 14.15.
#pragma once

#include "answer/graph_builder.h"
#include "filter/pieces.h"

namespace exsect::filter {

/// The graph, if y is x in other parameters, each an affine function of one of x, the surface is injective on
/// both squares together, and these have a rectangle in common: that is an overlap and there is nothing else.
/// Empty if that is not so, or not proved, or a polyline cannot keep within `accepted`; it keeps within
/// `tolerance` (space units, both) if it can. `boxes` counts the pairs looked at.
template <class K>
std::optional<GraphBuilder> overlap_of_pieces(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                              const PairOf<K>& pair, TreesOf<K>& trees, double tolerance,
                                              double accepted, long& boxes);

}  // namespace exsect::filter
