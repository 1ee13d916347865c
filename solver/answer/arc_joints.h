// Arcs of a graph joined at nodes that nobody has asked for, and divided at further ones. Internal to
// solver/.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include <vector>

namespace exsect {

/// From the given node and arc on, turning points are nodes with respect to `wanted` only; a closed curve
/// without any keeps all of its nodes.
void join_at_other_turning_points(IntersectionGraph& graph, std::size_t first_node, std::size_t first_arc,
                                  const std::vector<Parameter>& wanted);

/// Divides the arcs on a side of the cuspidal point, along which the patches lie on one surface, in that
/// node, whose point of space is within `error` of the true one; false if it lies inside of none.
bool divide_at(IntersectionGraph& graph, int node, double error);

}  // namespace exsect
