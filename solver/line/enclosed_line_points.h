// The points of a parameter line from its eliminant in balls.
#pragma once

#include <exsect/solver/line_query.h>

#include <optional>

namespace exsect {

/// As line_points, where balls of two doubles decide every sign that exact_line_points asks for; empty where
/// not.
std::optional<LinePoints> enclosed_line_points(const BezierPatch& x, const BezierPatch& y,
                                               const LineQuery& query);

}  // namespace exsect
