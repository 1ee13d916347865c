// An implicit surface of revolution against a biquadratic patch: a plane curve in the parameter square.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/revolution.h>
#include <exsect/solver/curve_arcs.h>

#include <vector>

namespace exsect {

struct RevolutionPatchCurve {
  /// A squarefree polynomial that vanishes exactly where g(x^2 + y^2, z) does on the patch; u in the place of
  /// r, v in that of s. Zero if the whole patch lies on the surface.
  BivariatePolynomial equation;
  /// v = 0 or v = 1 or both belong to the curve: these factors are not in `inner` and not in `arcs`.
  std::vector<int> whole_sides;
  BivariatePolynomial inner;
  CurveArcs arcs;
  /// For every arc: on the own sheet f(sqrt R, z) = 0, or on the mirrored one.
  std::vector<Sheet> sheets;
};

/// The curve where the patch meets f(r,z) = 0 revolved: g = even^2 - R odd^2, or even alone if odd = 0. The
/// sheet of an arc is decided by an exact sign at the sample of its gap. Throws std::domain_error for f = 0.
RevolutionPatchCurve intersect_revolution(const BivariatePolynomial& f, const BezierPatch& patch);

/// A point of the curve on a parameter line u = const, exactly known: v a real algebraic number.
struct RevolutionPatchPoint {
  RealAlgebraic v;
  Sheet sheet;
};
struct RevolutionPatchLine {
  std::vector<RevolutionPatchPoint> points;  // ascending in v
  bool whole_line;                           // u = const lies on the surface; then no points
};
/// All points of the curve on u = u0, u0 in [0,1]; std::invalid_argument otherwise.
RevolutionPatchLine points_on_line(const BivariatePolynomial& f, const BezierPatch& patch,
                                   const Rational& u0);

}  // namespace exsect
