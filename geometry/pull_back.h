// The plane and the quadratic cylinder of a parameter line, pulled back to the second patch.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/parameter_line.h>
#include <exsect/geometry/plane.h>
#include <exsect/geometry/rational_patch.h>

#include <array>

namespace exsect {

/// form(y(r,s)), bidegree at most (2,2).
BivariatePolynomial pull_back(const AffineForm& form, const BezierPatch& y);
/// form(Y/Y_4) Y_4 (16.1): the same zeros and signs on the square.
BivariatePolynomial pull_back(const AffineForm& form, const RationalPatch& y);

/// The forms of a conic parameter line c(t) (method, section 1): plane = 0 spans the line's plane, and
/// e0 : e1 : e2 = 1 : t : t^2 on the line, up to the common factor N. So the cylinder is e0 e2 - e1^2 = 0 and
/// t = e1/e0. For a line without weights e0 is the constant N, e1 = w1, e2 = w2.
template <class Ring>
struct LineFormsOver {
  AffineFormOver<Ring> plane;
  AffineFormOver<Ring> e0;
  AffineFormOver<Ring> e1;
  AffineFormOver<Ring> e2;

  friend bool operator==(const LineFormsOver&, const LineFormsOver&) = default;
};

using LineForms = LineFormsOver<Rational>;

/// Orthogonal cylinder of the method, (1.1) and (1.2): e0 = N = n.n, e1 = (a2 x n).(P - a0), e2 = (n x a1).(P
/// - a0), n = a1 x a2. Throws std::domain_error unless shape(line) is conic.
LineForms orthogonal_forms(const ParameterLine& line);
/// Cylinder along the axis k where |n_k| is largest: e0 = n_k, e1 = ((P - a0) x a2)_k, e2 = (a1 x (P -
/// a0))_k. The same conic on the plane with numbers half as long: the form used for solving. Throws as above.
LineForms axis_forms(const ParameterLine& line);
/// The same of a conic line with weights, whose homogeneous vectors are a[0] + a[1] t + a[2] t^2: with the
/// indices (i,j,4) of the vectors alone, e0 = a1 x a2, e1 = a2 x a0, e2 = a0 x a1, so e0 is no constant.
/// Throws std::domain_error unless the vectors are linearly independent and their plane is not at infinity.
LineForms axis_forms(const std::array<HomogeneousPoint, 3>& a);

/// P (2.1), U, L, M: pull-backs of plane, e0, e1, e2. The cylinder pulls back to Z = U M - L^2.
struct PullBack {
  BivariatePolynomial plane;  // P
  BivariatePolynomial u;      // U
  BivariatePolynomial l;      // L
  BivariatePolynomial m;      // M

  BivariatePolynomial cylinder() const { return u * m - l * l; }
};
PullBack pull_back(const LineForms& forms, const BezierPatch& y);
/// All multiplied by the denominator of the patch.
PullBack pull_back(const LineForms& forms, const RationalPatch& y);

}  // namespace exsect
