// Pairs of points in one order throughout a graph. Internal to solver/; docs/method.md, section 7.
#pragma once

#include <vector>

#include "answer/graph_builder.h"

namespace exsect {

/// The arcs of a self-intersection stand for unordered pairs of points, each in an order of its own. Where
/// arcs end in one pair in different orders, all that hangs together on the one side is exchanged, so that
/// they meet in one node; a curve that returns to a pair in the other order keeps both. `mates`: of the first
/// nodes, the node of the same pair in the other order. The graph has no overlaps.
void join_orders(GraphBuilder& graph, const std::vector<std::size_t>& mates);

/// These parameters and those of the other point, ascending: curves may be shown in the other order later.
std::vector<Parameter> in_both_orders(const std::vector<Parameter>& wanted);

}  // namespace exsect
