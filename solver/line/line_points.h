// The points of a parameter line of one patch on the other patch.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/line_query.h>

namespace exsect {

/// By the eliminant of the line, in balls of two doubles where they decide every sign (docs/method.md,
/// section 9), over the integers where not.
LinePoints line_points(const BezierPatch& x, const BezierPatch& y, const LineQuery& query);

}  // namespace exsect
