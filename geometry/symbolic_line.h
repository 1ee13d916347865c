// The lines x(u,.) of a patch with u as a variable: plane and cylinder over Q[u] and their pull-backs.
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/pull_back.h>
#include <exsect/geometry/trivariate_polynomial.h>

#include <array>

namespace exsect {

/// The line x(u,t) = a[0] + a[1] t + a[2] t^2; a[j][k] is coordinate k as a polynomial in u of degree at
/// most 2.
struct SymbolicLine {
  std::array<std::array<Polynomial, 3>, 3> a;

  ParameterLine at(const Rational& u) const;
};
SymbolicLine symbolic_line(const BezierPatch& x);

using SymbolicForm = AffineFormOver<Polynomial>;
using SymbolicLineForms = LineFormsOver<Polynomial>;

/// orthogonal_forms with u as a variable; at u0 it is orthogonal_forms of the line at u0. Degrees in u at
/// most: plane 6, e0 = N 8, e1 = w1 8, e2 = w2 8, so the cylinder 16 (method, section 1). Throws
/// std::domain_error if n = a1 x a2 vanishes for all u: every line is straight.
SymbolicLineForms orthogonal_forms(const SymbolicLine& line);

AffineForm at(const SymbolicForm& form, const Rational& u);
LineForms at(const SymbolicLineForms& forms, const Rational& u);

/// form(y(r,s)) as a polynomial in (u; r,s).
TrivariatePolynomial pull_back(const SymbolicForm& form, const BezierPatch& y);

/// P, U, L, M with u as a variable. Degrees in (u; r,s) at most: P (6,2,2), U (8,0,0), L and M (8,2,2),
/// cylinder (16,4,4).
struct SymbolicPullBack {
  TrivariatePolynomial plane;  // (9.23)
  TrivariatePolynomial u;
  TrivariatePolynomial l;
  TrivariatePolynomial m;

  TrivariatePolynomial cylinder() const { return u * m - l * l; }  // (9.24)
};
SymbolicPullBack pull_back(const SymbolicLineForms& forms, const BezierPatch& y);

/// P_r Z_s - P_s Z_r, degrees in (u; r,s) at most (18,5,5): zero where the line touches the patch (9.25). It
/// is -N det[N a1 + 2 L a2, y_r, y_s].
TrivariatePolynomial tangency_determinant(const SymbolicPullBack& pullback);

}  // namespace exsect
