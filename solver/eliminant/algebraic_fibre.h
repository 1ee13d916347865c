// Singular points of the intersection over an algebraic value of a parameter, exactly. Internal to solver/;
// docs/method.md, section 6.4.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <vector>

namespace exsect {

/// A singular point inside both squares over the value α of a sweep parameter. A second parameter `kept` is
/// an element of Q(α), a third, `eliminated`, a root of a polynomial over Q(α), and the fourth a function of
/// these.
struct SingularFibrePoint {
  CertifiedPoint at;  // exact() is known
  RealAlgebraic value;
  Parameter kept;
  Parameter eliminated;
  /// In the variables (kept, sweep): vanishes over α at every finite point of the fibre.
  BivariatePolynomial projection;
  /// In the variables (eliminated, sweep): vanishes at every point of the fibre with the same value of
  /// `kept`.
  BivariatePolynomial equation;

  /// True only if the fibre over α has no other point in the closed box.
  bool is_alone_in(const ParameterBox& box) const;
};

/// Those of which one parameter of the other patch is a rational function of `value` and a multiple root of
/// the fibre's projection: as a rule all, unless two have the same `value`.
std::vector<SingularFibrePoint> singular_points_over(const BezierPatch& x, const BezierPatch& y,
                                                     Parameter sweep, const RealAlgebraic& value);

/// True unless the fibre over `value` is finite.
bool may_have_infinite_fibre(const BezierPatch& x, const BezierPatch& y, Parameter sweep,
                             const RealAlgebraic& value);

}  // namespace exsect
