// The intersection of pairs that depend on a parameter through its square alone. Internal to solver/;
// docs/method.md, section 6.7.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include <optional>

#include "answer/run.h"

namespace exsect {

/// The intersection of the pair in terms of the squares (unfolded_parameters.h), in the parameters
/// themselves; empty if there is no such pair.
std::optional<IntersectResult> intersect_unfolded(const BezierPatch& x, const BezierPatch& y, const Run& run);

}  // namespace exsect
