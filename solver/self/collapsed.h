// Patches that meet themselves on parameter lines that are one point only. Internal to solver/;
// docs/method.md, section 7.10.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>

#include "answer/run.h"

namespace exsect {

/// A node for each line, if x has such lines v = constant or u = constant, and it is proved that these are
/// all pairs; empty otherwise.
std::optional<IntersectResult> self_intersect_collapsed(const BezierPatch& x, const Run& run);

}  // namespace exsect
