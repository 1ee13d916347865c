// Vectors of space with polynomial coordinates. Internal to solver/.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/rational_patch.h>

#include <array>

namespace exsect {

using PolynomialVector = std::array<BivariatePolynomial, 3>;

inline PolynomialVector cross(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline BivariatePolynomial dot(const PolynomialVector& a, const PolynomialVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline BivariatePolynomial dot(const Point& a, const PolynomialVector& b) {
  return b[0] * Polynomial(a[0]) + b[1] * Polynomial(a[1]) + b[2] * Polynomial(a[2]);
}

inline PolynomialVector derivative_r(const PolynomialVector& a) {
  return {a[0].derivative_r(), a[1].derivative_r(), a[2].derivative_r()};
}
inline PolynomialVector derivative_s(const PolynomialVector& a) {
  return {a[0].derivative_s(), a[1].derivative_s(), a[2].derivative_s()};
}

inline Point value(const PolynomialVector& a, const Rational& r, const Rational& s) {
  return {a[0](r, s), a[1](r, s), a[2](r, s)};
}

/// patch - origin, in (r,s): three polynomials that vanish where the patch is in the origin.
PolynomialVector coordinates_from(const BezierPatch& patch, const Point& origin);
/// The same times the weight X_4: X - X_4 origin.
PolynomialVector coordinates_from(const RationalPatch& patch, const Point& origin);

}  // namespace exsect
