// A strip along a planar curve that holds one regular arc of the zero set of a function
// (docs/method-implicit.md, 10.4).
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/planar_function.h>

#include <optional>
#include <string>
#include <vector>

namespace exsect {

/// Where a statement could not be proved: a closed interval of the curve's parameter, and why.
struct Unproved {
  RationalInterval t;
  std::string why;
};

/// Two-sided: with N(t) = W^2 (-y', x')/W (W = 1 for a polynomial curve), every segment p(t) + s N(t), |s| <=
/// half_width, holds exactly one zero of f, not at its ends; these zeros form one regular arc, a graph over
/// the curve, in whose points grad f is not zero. Arc and curve are within `distance` = half_width max|N| of
/// each other, in both directions. The normal segments cover a neighbourhood of the curve without folding:
/// their map has a positive Jacobian (10.12).
struct TwoSidedBound {
  struct Strip {
    Rational half_width;
    Rational distance;
  };
  std::optional<Strip> strip;
  std::vector<Unproved> unproved;  // for the last strip tried
};

/// Nothing is assumed about f. Throws std::invalid_argument unless the curve is planar and no point.
TwoSidedBound two_sided_bound(const PlanarFunction& f, const BezierCurve& curve);

}  // namespace exsect
