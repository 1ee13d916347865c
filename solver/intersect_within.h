// An intersection as a part of a call that is under way. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include "answer/run.h"

namespace exsect {

/// As intersect(): within the call's time, its work on the call's record.
IntersectResult intersect_within(const Run& run, const BezierPatch& x, const BezierPatch& y);
/// The same for models of any size and place: moved and scaled where that helps.
IntersectResult intersect_in_place(const Run& run, const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
