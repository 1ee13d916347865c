// Where a patch of any kind meets itself, in doubles. Internal to solver/; docs/method-doubles.md,
// section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <functional>

#include "answer/run.h"
#include "self/glued_cells.h"

namespace exsect {

/// As self_intersect(); where doubles do not decide, an incomplete result says where the search ended.
IntersectResult self_intersect_in_doubles(const RationalPatch& x, const Run& run);

/// What `finish` makes of the curves in cells that have none of the lines inside, for the first one of some
/// grids of cells for which that is complete; else an incomplete result. Turning points are nodes in both
/// orders of the pairs. Requires that x is reduced and about the origin.
IntersectResult self_intersect_in_cells(const RationalPatch& x, const ParameterLines& lines, const Run& run,
                                        const std::function<IntersectResult(GluedCells)>& finish);

}  // namespace exsect
