// Patches in a plane that the other patch does not reach. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include <optional>

namespace exsect {

/// The empty intersection, if one of the patches lies in a plane on one side of which the whole other surface
/// is, its first or second parameter in [0,1]; decided exactly by a discriminant, however close they are.
/// Empty otherwise.
std::optional<IntersectResult> intersect_missed_plane(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
