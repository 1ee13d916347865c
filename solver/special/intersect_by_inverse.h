// Pairs of which one patch has an inverse of forms: an equation on the other one, cut by its sides. Internal
// to solver/; docs/method-equations.md, section 17.19.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <optional>

#include "answer/run.h"
#include "special/patch_inverse.h"

namespace exsect {

/// Whatever meets there, by the inverse of y. Empty if x lies on the surface of y or maps a part of their
/// curve to one point, the curve has too high a degree in x, or it goes through a pole of y.
std::optional<IntersectResult> intersect_by_inverse(const RationalPatch& x, const RationalPatch& y,
                                                    const PatchInverse& of_y, const Run& run);

}  // namespace exsect
