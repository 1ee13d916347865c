// Approximate implicit equations of a biquadratic patch, with a proved bound of their values on it.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/space_polynomial.h>

namespace exsect {

/// How the equation is found, by a singular value decomposition.
enum class PatchFit {
  /// Dokken's method: least Bernstein coefficients of q(x(u,v)), for degree 4 a matrix of 81 by 35.
  dokken,
  /// Least values at 2d + 1 points on each of the six conics u = 0, 1/2, 1 and v = 0, 1/2, 1: a polynomial of
  /// degree d with 2d + 1 zeros on a conic contains it. For degree 4 a matrix of 45 by 35 (chapter, 9.4).
  conics,
};

const char* name(PatchFit method);

struct ApproximateEquation {
  /// Rational coefficients of a few dozen bits.
  SpacePolynomial equation;
  /// |equation(x(u,v))| <= bound for all (u,v) in [0,1]^2, from Bernstein coefficients of this polynomial
  /// itself. 0 exactly where the patch has an equation of the degree asked for, which is then the result.
  Rational bound;
  /// The unit in which `bound` is to be read (11.3): the least singular value belongs to coefficients of
  /// length 1 in the coordinates (P - centre) / unit.
  Point centre;
  Rational unit;
  double singular_value;
};

/// The equation of total degree `degree`. Throws std::invalid_argument unless 1 <= degree <= 7 (dokken), 1 <=
/// degree <= 5 (conics), std::domain_error for a net beyond the range of doubles, or if all control points
/// agree.
ApproximateEquation approximate_equation(const BezierPatch& x, int degree, PatchFit method);

}  // namespace exsect
