// The curve in a pinch cell. Internal to solver/; docs/method-doubles.md, section 14.17.
#pragma once

#include <vector>

#include "answer/graph_builder.h"
#include "self/cell_pairs.h"

namespace exsect {

/// Adds the arc between the two ends, or from the pinch point, which becomes a node of kind cusp, to the only
/// one; from a pinch point on a side there is one only. `ends`: nodes where all curves in the pairs of the
/// cell with itself leave it, one or two; `mates`: of these the nodes of the other order. Drawn to within
/// `tolerance`, a length, if that can be. False if the pinch point, or a vertex, is not enclosed, or an order
/// not known.
bool add_pinch_arc(GraphBuilder& graph, const std::vector<std::size_t>& mates, const PinchCell& pinch,
                   const ParameterCell& cell, const std::vector<int>& ends, double tolerance);

}  // namespace exsect
