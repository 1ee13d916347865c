// Patches that are a curve or a single point, against any patch. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>

#include "answer/run.h"

namespace exsect {

/// The intersection if one of the patches is a curve or a point; empty if both are surfaces.
std::optional<IntersectResult> intersect_degenerate(const BezierPatch& x, const BezierPatch& y,
                                                    const Run& run);

}  // namespace exsect
