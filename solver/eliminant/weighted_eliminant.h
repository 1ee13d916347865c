// The eliminant E(u) of the turning points with respect to u of patches with weights. Internal to solver/;
// docs/method-equations.md, section 16.1.
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/rational_patch.h>

#include <optional>
#include <vector>

namespace exsect {

/// E(u) != 0 of (16.9): what turning_eliminant promises of its roots holds for the solutions of X = λY with
/// X, Y != 0. Of degree at most 160; primitive with integer coefficients, positive leading coefficient. Empty
/// where it is not defined (patches of lower degrees, quadrics, contact along a curve) or would have over
/// 2^19 bits. Requires x and y of bidegrees at most (2,2).
std::optional<Polynomial> weighted_eliminant(const RationalPatch& x, const RationalPatch& y);

/// The roots of E(u) in [0,1] as by isolate_enclosed_roots: each of them is simple. Empty where E is not
/// defined, or 256 bits of its values and 1024 bits of its coefficients are too few, as next to a multiple
/// root.
std::optional<std::vector<RationalInterval>> weighted_turning_roots(const RationalPatch& x,
                                                                    const RationalPatch& y);

}  // namespace exsect
