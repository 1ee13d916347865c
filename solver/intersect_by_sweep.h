// The intersection by sections 5 and 6 of docs/method.md alone. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include "run.h"

namespace exsect {

/// As intersect() in exact mode, with nothing taken from the solution in doubles. The options have been
/// checked.
IntersectResult intersect_by_sweep(const BezierPatch& x, const BezierPatch& y, const Run& run);

}  // namespace exsect
