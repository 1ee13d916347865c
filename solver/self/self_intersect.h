// Where a patch meets itself: exact, complete, certified.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/options.h>
#include <exsect/solver/result.h>

namespace exsect {

/// All unordered pairs of different parameters in [0,1]^2 with x(u1,v1) = x(u2,v2), and the cuspidal points
/// where curves of such pairs end (method, section 7). The result is that of intersect() with (u1,v1,u2,v2)
/// in the places of (u,v,r,s):
///
/// * Every curve is reported once, in one of the two orders of its pairs, the same all along the curve.
/// * A node of kind `cusp` is a cuspidal point, x_u x x_v = 0: there (u1,v1) = (u2,v2), and one arc ends.
/// * A side that is one point of space is an isolated node with both parameters along it free.
/// * A patch with x(sigma(w)) = x(w) for an affine map sigma has the overlap w, sigma(w) with itself. Its
///   chain has arcs of place `interior` where the two points of a pair agree, and on a cut from the centre of
///   a half turn sigma.
/// * A point of space where curves cross (three or more sheets of the surface) is no node: the curves have
///   different parameters there.
///
/// Throws std::invalid_argument for options out of range. Safe to call from several threads.
IntersectResult self_intersect(const BezierPatch& x, const IntersectOptions& options = {});

}  // namespace exsect
