// Pairs of which one patch has an inverse of forms: an equation on the other one, cut by its sides. Internal
// to solver/; docs/method-equations.md, section 17.19.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <optional>

#include "answer/run.h"
#include "special/patch_inverse.h"

namespace exsect {

/// Whatever meets there, by the inverse of y. Empty if a part of the curve is one point of x, the curve, or
/// the sides of y where x lies on its surface, are of too high degrees in x, or a pole of y is on them.
std::optional<IntersectResult> intersect_by_inverse(const RationalPatch& x, const RationalPatch& y,
                                                    const PatchInverse& of_y, const Run& run);

}  // namespace exsect
