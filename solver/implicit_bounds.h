// Certified distances between a parametrised curve and the zero set of an implicit function
// (docs/method.md, 10.4).
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

/// One-sided: every point of the curve is within `distance` of a zero of f.
struct OneSidedBound {
  /// Nothing if it could not be proved; then `unproved` says where.
  std::optional<Rational> distance;
  /// |f| <= residual along the curve; nothing where f is not defined on the whole curve.
  std::optional<Rational> residual;
  std::vector<Unproved> unproved;
};

/// Two-sided: with N(t) = W^2 (-y', x')/W (W = 1 for a polynomial curve), every segment p(t) + s N(t), |s| <=
/// half_width, holds exactly one zero of f, not at its ends; these zeros form one regular arc, a graph over
/// the curve, in whose points grad f is not zero. Arc and curve are within `distance` = half_width max|N| of
/// each other, in both directions. The normal segments cover a neighbourhood of the curve without folding:
/// their map has a positive Jacobian.
struct TwoSidedBound {
  struct Strip {
    Rational half_width;
    Rational distance;
  };
  std::optional<Strip> strip;
  std::vector<Unproved> unproved;  // for the last strip tried
};

struct DistanceBounds {
  OneSidedBound one_sided;
  TwoSidedBound two_sided;
};

/// Bounds of a planar curve against f; nothing is assumed about f. For a profile (r,z) with r >= 0 on the
/// curve the bounds are those of the surfaces of revolution. Throws std::invalid_argument unless the curve is
/// planar and no point.
DistanceBounds distance_bounds(const PlanarFunction& f, const BezierCurve& curve);
OneSidedBound one_sided_bound(const PlanarFunction& f, const BezierCurve& curve);
TwoSidedBound two_sided_bound(const PlanarFunction& f, const BezierCurve& curve);

/// Boxes inside `box` outside of which f = f_x = f_y = 0 has no solution in `box`: empty proves that the zero
/// set has no singular point there. At most `max_boxes` boxes are examined. Where a spline is not defined
/// nothing is claimed.
std::vector<PlanarBox> possibly_singular(const PlanarFunction& f, const PlanarBox& box, int max_boxes = 4096);

}  // namespace exsect
