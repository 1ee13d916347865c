// The curves in pairs of cells put together. Internal to solver/; docs/method-doubles.md, section 14.17.
#pragma once

#include <array>
#include <vector>

#include "answer/graph_builder.h"
#include "self/cell_pairs.h"

namespace exsect {

/// `mates` as in join_orders(). Where curves go on across a cut, they end in one node, that of kind turning
/// with respect to no parameter, or in both orders of it. With problems there is no graph.
struct GluedCells {
  GraphBuilder graph;
  std::vector<std::size_t> mates;
  std::vector<std::array<ParameterRectangle, 2>> cells;  // of the graph's arcs, in the order of their pairs
  std::vector<Incomplete> problems;
};

/// Requires that `pairs` has no problems. `tolerance`: of polylines next to pinch points, a length.
GluedCells glued_cells(const CellPairs& pairs, double tolerance);

}  // namespace exsect
