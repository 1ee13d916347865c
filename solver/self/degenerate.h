// Patches that are a curve or a point, or cover a surface twice by a straight fold, against themselves.
// Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>

#include "answer/run.h"

namespace exsect {

/// A bilinear patch in a plane, each point of which has two preimages (7.11): (u,v) and (u,v) + t(u,v)
/// direction, t = t[0] + t[1] u + t[2] v; the fold is t = 0.
struct PlanarFold {
  std::array<Rational, 3> t;
  std::array<Rational, 2> direction;
};

/// Empty if x is not bilinear or not in a plane, or if c10 or c01 is a multiple of c11 (coefficients of u, v,
/// u v).
std::optional<PlanarFold> planar_fold(const BezierPatch& x);

/// The value of u at which a planar bilinear patch, c01 = -u c11, has a line u = constant that is one point;
/// empty if it has none. Apart from this line x is injective.
std::optional<Rational> collapsed_line(const BezierPatch& x);

/// All pairs on a parameter line (fixed: u, 0, or v, 1) that is one point: a node with both parameters along
/// it free.
Node collapsed_line_node(const BezierPatch& x, std::size_t fixed, const Rational& value);

/// The self-intersection of a folded patch, in u or in v, that does not meet itself in another way, of a
/// planar bilinear patch, and of a curve or a point; empty for all other patches.
std::optional<IntersectResult> self_intersect_degenerate(const BezierPatch& x, const Run& run);

}  // namespace exsect
