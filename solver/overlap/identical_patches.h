// A patch and itself, given twice. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>

#include "answer/run.h"

namespace exsect {

/// The intersection if y is x, possibly with its parameters exchanged or reversed: an overlap, which is all
/// of both squares, and every pair of self_intersect in both orders. Empty otherwise, and for patches in a
/// plane.
std::optional<IntersectResult> intersect_identical(const BezierPatch& x, const BezierPatch& y,
                                                   const Run& run);

}  // namespace exsect
