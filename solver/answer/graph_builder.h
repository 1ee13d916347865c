// Components of a graph from its nodes and arcs. Internal to solver/.
#pragma once

#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/result.h>

#include <optional>

namespace exsect {

/// If the arc's polyline is not proved to keep within `tolerance` (space units): where it starts, and that.
std::optional<Incomplete> too_coarse(const IntersectionGraph& graph, const Arc& arc, double tolerance);

/// Fills in components from nodes and arcs, and drops the nodes that no arc, no isolated point and no
/// overlap names.
void finish_components(IntersectionGraph& graph);

}  // namespace exsect
