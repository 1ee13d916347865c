// The implicit equation of a biquadratic patch, exact.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/space_polynomial.h>

namespace exsect {

/// The equation of least degree that vanishes on the patch: irreducible over Q, coprime integer coefficients,
/// positive leading coefficient. Degree 8 in general, by Dixon's determinant; a lower degree is found, and
/// the absence of lower ones proved, by ranks over Q (docs/method-implicit.md, section 11). Throws
/// std::domain_error if the patch is no surface: x_u x x_v = 0 for all u, v.
SpacePolynomial implicit_equation(const BezierPatch& x);

/// A basis of the equations of degree at most `degree` that vanish on the patch; for the least degree that
/// has one it is that equation alone. Throws std::invalid_argument unless 1 <= degree <= 8.
std::vector<SpacePolynomial> vanishing_equations(const BezierPatch& x, int degree);

/// f((x - shift) scale), coordinate by coordinate.
SpacePolynomial affinely_substituted(const SpacePolynomial& f, const Point& shift, const Point& scale);

}  // namespace exsect
