// Pairs of patches that meet in a common pole alone. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include <optional>

namespace exsect {

/// The intersection, if a plane through a common pole separates the patches otherwise: one isolated node.
/// Empty if no plane is found. With it pairs are decided that lie on one surface, such as opposite quarters
/// of a dome.
std::optional<IntersectResult> intersect_in_pole(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
