// Vectors of space with polynomial coordinates. Internal to solver/.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>

namespace exsect {

using PolynomialVector = std::array<BivariatePolynomial, 3>;

inline PolynomialVector cross(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline BivariatePolynomial dot(const PolynomialVector& a, const PolynomialVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// patch - origin, in (r,s): three polynomials that vanish where the patch is in the origin.
PolynomialVector coordinates_from(const BezierPatch& patch, const Point& origin);

}  // namespace exsect
