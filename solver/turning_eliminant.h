// The eliminant E(u) of the turning points with respect to u.
#pragma once

#include <optional>
#include <string>

#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/bezier_patch.h>

namespace exsect {

/// E(u), degree at most 128 (proof in docs/method.md): every u in [0,1] where the fibre x(u,.) with y has a multiple
/// point, complex and phantom ones included, is a root; a simple root lies under no singular point of the
/// intersection. Primitive with integer coefficients, positive leading coefficient.
struct TurningEliminant {
  /// Empty if E is not defined for this pair (degenerate shape), with the reason in `degenerate`.
  std::optional<Polynomial> polynomial;
  std::string degenerate;
};

/// Exchange patches or parameters for turning points with respect to v, r, s.
TurningEliminant turning_eliminant(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
