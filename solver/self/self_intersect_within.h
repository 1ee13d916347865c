// A self-intersection as a part of a call that is under way. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include "answer/run.h"

namespace exsect {

/// As self_intersect(): within the call's time, its work on the call's record.
IntersectResult self_intersect_within(const Run& run, const BezierPatch& x);

}  // namespace exsect
