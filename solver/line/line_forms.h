// The closed formula for the eliminant of a conic parameter line with a patch (docs/method.md, section 9).
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/pull_back.h>

#include "line/line_place.h"

namespace exsect {

/// Everything the fibre of a conic line needs, polynomials in s with integer coefficients. With P = A r^2 + B
/// r + C and Z the pull-backs of plane and cylinder, up to positive constants:
///   eliminant = Res_r(P, Z) with formal degrees 2 and 4, by (F1) and (F2),
///   A^3 Z = s1 r + s0 modulo P (3.1).
/// At a root of the eliminant with s1 != 0 there is exactly one common point: r = -s0/s1 and t =
/// -t_numerator/s1.
struct ConicForms {
  Polynomial a;  // A, B, C
  Polynomial b;
  Polynomial c;
  Polynomial eliminant;
  Polynomial s1;
  Polynomial s0;
  Polynomial t_numerator;
};

/// Requires is_conic(problem.line); the forms mean nothing for a straight line.
ConicForms conic_forms(const IntegerLineAndPatch& problem);

}  // namespace exsect
