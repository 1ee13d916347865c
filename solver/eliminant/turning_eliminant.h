// The eliminant E(u) of the turning points with respect to u.
#pragma once

#include <exsect/algebra/enclosed_roots.h>
#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/bezier_patch.h>

#include <optional>
#include <string>

namespace exsect {

/// E(u) != 0 (proofs in docs/method.md, section 4):
///  - every complex u over which the fibre x(u,.) = y has a multiple point, at finite v, r, s, inside the
///    unit squares or not, or is not finite, is a root;
///  - a simple root lies under no singular point of the complex intersection curve, and under at most one
///    multiple point;
///  - a root may also come from a point of the fibre at infinity, and a multiple root decides nothing.
/// The degree is 128 for generic patches. Primitive with integer coefficients, positive leading coefficient.
///
/// Where the patches touch along a curve, every fibre has a multiple point; `touching` is set, and the roots
/// are all u over which points of the fibre in the complex domain meet, or are not finite (4.20). Their
/// multiplicities say nothing.
struct TurningEliminant {
  /// Empty if E is not defined for this pair (degenerate shape), or would have over 2^19 bits (control points
  /// with hundreds of digits), with the reason in `degenerate`.
  std::optional<Polynomial> polynomial;
  std::string degenerate;
  bool touching = false;
  /// A factor of `polynomial`: the multiplicities of its roots mean nothing.
  Polynomial unweighted = 1;
};

/// Exchange patches or parameters for turning points with respect to v, r, s.
TurningEliminant turning_eliminant(const BezierPatch& x, const BezierPatch& y);

/// Leading bits of E(u) up to a positive factor, in a third of the time; empty where (4.8) does not define
/// it.
std::optional<EnclosedPolynomial> enclosed_turning_eliminant(const BezierPatch& x, const BezierPatch& y);

/// The roots of E(u) in [0,1] as by isolate_enclosed_roots, from enclosures of its values, and where these
/// decide nothing or the numbers are short, of its coefficients. Empty where neither does.
std::optional<std::vector<RationalInterval>> enclosed_turning_roots(const BezierPatch& x,
                                                                    const BezierPatch& y);

}  // namespace exsect
