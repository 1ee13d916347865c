// Pairs of which a patch depends on one of its parameters through a square alone. Internal to solver/;
// docs/method.md, section 6.7.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>

#include "run.h"

namespace exsect {

/// The intersection if each parameter that a patch depends on through a square alone runs through it once,
/// and there is one: that of the patches in terms of the squares, in the parameters themselves. Empty
/// otherwise.
std::optional<IntersectResult> intersect_unfolded(const BezierPatch& x, const BezierPatch& y, const Run& run);

}  // namespace exsect
