// Patches that lie on one surface: overlap regions. Internal to solver/; docs/method.md, section 6.3.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>

#include "answer/run.h"

namespace exsect {

/// The intersection if {x = y} has a part of dimension two over C; empty if not. Requires that neither patch
/// is a curve or a point.
std::optional<IntersectResult> intersect_on_one_surface(const BezierPatch& x, const BezierPatch& y,
                                                        const Run& run);

}  // namespace exsect
