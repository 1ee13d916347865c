// Axis-parallel boxes of space with exact rational ends.
#pragma once

#include <exsect/geometry/bezier_patch.h>

namespace exsect {

class RationalPatch;

/// The closed box lower <= P <= upper in every coordinate. Invariant: lower[k] <= upper[k].
struct BoundingBox {
  Point lower;
  Point upper;

  bool contains(const Point& p) const;
  friend bool operator==(const BoundingBox&, const BoundingBox&) = default;
};

/// The box of the control net; it contains the patch over [0,1]^2 (convex hull property).
BoundingBox bounding_box(const BezierPatch& x);
/// A box that contains the patch over [0,1]^2: that of the control points if all weights are positive, else
/// of those of its parts, which are halved until theirs are.
BoundingBox bounding_box(const RationalPatch& x);
/// The smallest box that contains both.
BoundingBox united(const BoundingBox& a, const BoundingBox& b);
/// True if the closed boxes have a point in common, be it on their rims.
bool intersects(const BoundingBox& a, const BoundingBox& b);
/// The largest edge length, >= 0.
Rational largest_extent(const BoundingBox& box);

}  // namespace exsect
