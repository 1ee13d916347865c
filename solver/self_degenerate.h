// Patches that are a curve or a point, or cover a surface twice by a fold, against themselves. Internal to
// solver/.
#pragma once

#include <exsect/solver/intersect.h>

#include <optional>

namespace exsect {

/// x = a(v) + b(v) (u - fold)^2: every line v = constant is straight and run through twice.
struct FoldedPatch {
  Rational fold;
  std::array<Point, 3> a;  // coefficients of v^j
  std::array<Point, 3> b;
};

/// Empty if x is none, or does not depend on u.
std::optional<FoldedPatch> folded_patch(const BezierPatch& x);

/// The self-intersection of such a patch, in u or in v, that does not meet itself in another way, and of a
/// curve or a point; empty for all other patches.
std::optional<IntersectResult> self_intersect_degenerate(const BezierPatch& x,
                                                         const IntersectOptions& options);

}  // namespace exsect
