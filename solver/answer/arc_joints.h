// Arcs of a graph joined at nodes that nobody has asked for, and divided at further ones. Internal to
// solver/.
#pragma once

#include <functional>
#include <vector>

#include "answer/graph_builder.h"

namespace exsect {

/// From the given arc on, where every closed curve has a node of a kind.
void join_at_nodes_of_no_kind(GraphBuilder& graph, int first_arc);

/// From the given node and arc on, turning points are nodes with respect to `wanted` only; a closed curve
/// without any keeps all of its nodes.
void join_at_other_turning_points(GraphBuilder& graph, int first_node, int first_arc,
                                  const std::vector<Parameter>& wanted);

/// The arcs of a closed chain, joined at the nodes that are not wanted, one of which is.
std::vector<Arc> joined_chain(std::vector<Arc> chain, const std::function<bool(int)>& is_wanted);

/// Divides the arcs on a side of the cuspidal point, along which the patches lie on one surface, in that
/// node, whose point of space is within `error` of the true one; false if it lies inside of none.
bool divide_at(GraphBuilder& graph, int node, double error);

}  // namespace exsect
