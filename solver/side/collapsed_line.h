// A parameter line that is one point of space, on the other patch. Internal to solver/.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include "side/line_arcs.h"

namespace exsect {

/// The line, mapped to one point: an arc all along it for every point (r,s) of the other patch there, with
/// constant r and s. Incomplete if these are not isolated, apart from sides of y that are the same
/// point (common_pole.h).
LineArcs arcs_of_collapsed_line(const BezierPatch& x, const BezierPatch& y, const LineQuery& query);

/// Two sides of one patch.
bool is_corner(const std::vector<Side>& on);

/// The node of such an arc: one point of space, at which the parameter along the line is free. `inside` is a
/// point of the arc.
Node collapsed_node(const CertifiedPoint& inside, const Node& at_inside, Parameter along);

}  // namespace exsect
