// The points of a parameter line from its eliminant over the integers.
#pragma once

#include <exsect/solver/line_query.h>

namespace exsect {

/// As line_points, with every point as an exact algebraic number from the start.
LinePoints exact_line_points(const BezierPatch& x, const BezierPatch& y, const LineQuery& query);

}  // namespace exsect
