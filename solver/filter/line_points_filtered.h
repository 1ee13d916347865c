// The points of a parameter line on the other patch, decided in doubles where they suffice.
#pragma once

#include <exsect/solver/line_query.h>

namespace exsect {

/// The same points, decided in doubles with proved errors where they suffice (docs/method-doubles.md,
/// section 14.3) and by line_points where not. Boxes are as narrow as doubles allow; refinement and branches
/// go back to line_points.
LinePoints line_points_filtered(const BezierPatch& x, const BezierPatch& y, const LineQuery& query);

}  // namespace exsect
