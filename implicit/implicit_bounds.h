// Certified distances between a parametrised curve and the zero set of an implicit function
// (docs/method-implicit.md, 10.4).
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/planar_function.h>
#include <exsect/implicit/two_sided_bound.h>

#include <optional>
#include <vector>

namespace exsect {

/// One-sided: every point of the curve is within `distance` of a zero of f, by (10.8).
struct OneSidedBound {
  /// Nothing if it could not be proved; then `unproved` says where.
  std::optional<Rational> distance;
  /// |f| <= residual along the curve; nothing where f is not defined on the whole curve.
  std::optional<Rational> residual;
  std::vector<Unproved> unproved;
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

/// Boxes inside `box` outside of which f = f_x = f_y = 0 has no solution in `box`: empty proves that the zero
/// set has no singular point there. At most `max_boxes` boxes are examined. Where a spline is not defined
/// nothing is claimed.
std::vector<PlanarBox> possibly_singular(const PlanarFunction& f, const PlanarBox& box, int max_boxes = 4096);

}  // namespace exsect
