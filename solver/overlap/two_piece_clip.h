// The curves of two pieces of one surface, cut out of the self-intersection of the rectangle around both.
// Internal to solver/; docs/method.md, section 6.3.
#pragma once

#include <optional>
#include <vector>

#include "answer/run.h"
#include "overlap/overlap_boundary.h"
#include "overlap/two_pieces.h"

namespace exsect {

/// Appends the arcs, apart from those on sides, and the isolated points. `nodes`: the nodes of the points of
/// `boundary`, whose arcs are complete. Returns the nodes of cuspidal points that lie inside of arcs of the
/// boundary and in which an arc ends; empty if the curves are not decided this way.
std::optional<std::vector<int>> append_clipped_curves(GraphBuilder& graph, const TwoPieces& pieces,
                                                      const OverlapBoundary& boundary,
                                                      const std::vector<int>& nodes, const Run& run);

}  // namespace exsect
