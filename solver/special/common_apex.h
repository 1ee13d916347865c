// Two cones with a common apex. Internal to solver/; docs/method.md, section 6.2.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include <optional>

namespace exsect {

/// The intersection of x = Q + u c(v) and y = Q + r d(s), c and d without zeros, up to exchanged and reversed
/// parameters: straight arcs from the apex, u = r = 0, one for each common ruling. Empty if the patches are
/// not of this form, or if they have infinitely many rulings in common.
std::optional<IntersectResult> intersect_cones(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
