// Patches that lie in a plane: their folds, and the turning values of the curves in which others meet them.
// Internal to solver/; docs/method.md, section 4.8.
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/plane.h>

#include <optional>
#include <vector>

namespace exsect {

/// Vectors other than zero that span the orthogonal complement of the vectors' span in space, of which none
/// may be zero.
std::vector<Point> orthogonal_complement(const std::vector<Point>& vectors);

/// The plane of the patch; empty if its control points lie in none, or in more than one.
std::optional<AffineForm> plane_of(const BezierPatch& x);

/// Whether x_u x x_v vanishes at some point of [0,1]^2. Requires that x lies in a plane.
bool planar_patch_folds(const BezierPatch& x);

/// D(u) (4.22), whose roots are the turning values with respect to u of the intersection with y: a multiple
/// one lies under every singular point in [0,1]^4. Empty unless y lies in one plane, is regular on all of its
/// square, and x meets that plane in a curve without multiple components other than lines u = const.
std::optional<Polynomial> planar_turning_eliminant(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
