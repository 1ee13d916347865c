// A proof that only a patch's symmetries map different points to one. Internal to solver/; docs/method.md,
// section 7.9.
#pragma once

#include <exsect/geometry/bezier_patch.h>

namespace exsect {

/// True only if x has no pairs of different points with one image but w, sigma(w) with one of its symmetries
/// sigma. Folded patches are left to their quotients.
bool has_only_symmetric_pairs(const BezierPatch& x);

/// True only if n(u,v) is nowhere 0 in the square: on each of the pieces it is divided into, all Bernstein
/// coefficients lie on one side of a plane through the origin.
bool is_away_from_origin(const BezierPatch& n);

}  // namespace exsect
