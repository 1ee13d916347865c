// Patches that depend on one of their parameters through a square alone. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>

namespace exsect {

/// x = a(v) + b(v) (u - fold)^2: every line v = constant is straight, and all turn back at the same u.
struct FoldedPatch {
  Rational fold;
  std::array<Point, 3> a;  // coefficients of v^j
  std::array<Point, 3> b;
};

/// Empty if x is none, or does not depend on u.
std::optional<FoldedPatch> folded_patch(const BezierPatch& x);

/// a + b q over the values q of (u - fold)^2, 0 <= u <= 1, as a patch in (q - least) / (greatest - least):
/// run through once.
BezierPatch unfolded(const FoldedPatch& patch);

}  // namespace exsect
