// Pairs that are divided into pieces, which are intersected one by one. Internal to solver/; docs/method.md,
// section 6.8.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include <optional>

#include "answer/run.h"

namespace exsect {

/// Empty if the pair is not to be divided, or patches overlap.
std::optional<IntersectResult> intersect_divided(const BezierPatch& x, const BezierPatch& y, const Run& run);

}  // namespace exsect
