// Pairs of which one patch has an inverse of forms: an equation on the other one, cut by its sides. Internal
// to solver/; docs/method-equations.md, section 17.19.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <optional>

#include "answer/run.h"
#include "special/patch_inverse.h"

namespace exsect {

/// Poles of y on the curve: an arc that ends in one has there, for the parameter along its side, only about
/// that of the vertex next to it, so that they are left to the inverse of the other patch if it has one.
enum class PolesOfInverse { left_to_others, allowed };

/// Whatever meets there, by the inverse of y. Empty if a part of the curve inside of x is one point of x, the
/// curve, or the sides of y where x lies on its surface, are of too high degrees in x, or a pole of y is on
/// them and left to others, or is one of x as well.
std::optional<IntersectResult> intersect_by_inverse(const RationalPatch& x, const RationalPatch& y,
                                                    const PatchInverse& of_y, const Run& run,
                                                    PolesOfInverse poles = PolesOfInverse::allowed);

}  // namespace exsect
