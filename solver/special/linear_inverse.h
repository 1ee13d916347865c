// Patches whose parameters are quotients of linear functions of their points: parallelograms, trapezoids,
// bilinear patches, and rational cylinders and cones. Internal to solver/; docs/method-equations.md, section
// 17.19.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <optional>
#include <vector>

namespace exsect {

/// h.X of homogeneous coordinates X.
using LinearForm = HomogeneousPoint;
BivariatePolynomial on_patch(const LinearForm& form, const RationalPatch& x);

/// A parameter of the patch is numerator / denominator there, and denominator > bound w > 0 with the weight
/// w.
struct ParameterQuotient {
  LinearForm numerator;
  LinearForm denominator;
  Rational bound;
};

/// The multiples of points of the patch with positive weights w are the vectors with w > 0 and equation = 0
/// for which the denominators are at least bound w and the quotients are in [0,1] (Lemma 17.15).
struct LinearInverse {
  std::vector<Integer>
      equation;  // of 1 or of 2: coefficients of X_i, or of X_i X_j, i <= j, lexicographically
  std::array<ParameterQuotient, 2> parameters;
};

/// Empty if the patch has no such inverse, or none is found.
std::optional<LinearInverse> linear_inverse(const RationalPatch& y);

/// The equation on another patch: it vanishes where x is on the surface of the patch.
BivariatePolynomial section_of(const LinearInverse& inverse, const RationalPatch& x);

}  // namespace exsect
