// The implicit equation of a planar rational Bézier curve, exact.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/bezier_curve.h>

namespace exsect {

/// The algebraic curve that carries a parametrised planar curve. Polynomials in (x,y) have x as their first
/// variable r and y as their second s.
struct ImplicitCurve {
  /// Irreducible over Q, coprime integer coefficients, positive leading coefficient (x before y); vanishes on
  /// the parametrised curve.
  BivariatePolynomial equation;
  /// The parametrisation runs through the curve `power` times over the complex numbers: Bezout's determinant
  /// is a constant times equation^power. 1 for a proper parametrisation.
  int power;
};

/// Bezout's determinant (10.1) with common factors of the homogeneous coordinates removed first. Throws
/// std::invalid_argument unless the curve is planar and not a point.
ImplicitCurve implicit_curve(const BezierCurve& curve);

/// The n x n matrix (10.1) for x = X/W, y = Y/W, n the degree: entries linear in (x,y).
std::vector<std::vector<BivariatePolynomial>> bezout_matrix(const HomogeneousCurve& curve);

/// W^d f(X/W, Y/W), d the total degree of f: vanishes exactly where f does on the curve.
Polynomial composed(const BivariatePolynomial& f, const HomogeneousCurve& curve);

}  // namespace exsect
