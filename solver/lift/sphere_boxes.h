// What two boxes of one sphere about different axes share. Internal to solver/; docs/method-equations.md,
// section 17.12.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <vector>

#include "lift/lifted_curve.h"

namespace exsect {

/// In a circle that a bound's plane cuts out, the arcs and nodes that are left of it.
struct SphereCircle {
  LiftedCurve curve;
  std::vector<std::size_t> points;  // of each node: equal numbers for one point of space
};

/// Invariant: the part of the sphere in a region is the closure of its inner points, if it has any, and the
/// arcs of the circles and the points without arcs, none of which is in that closure but for ends of arcs.
struct SphereRegion {
  bool has_inner_points = false;
  std::vector<SphereCircle> circles;
};

/// Requires a sphere, and bounds of degree 1, all with a name.
SphereRegion sphere_region(const ImplicitSurface& sphere, const SurfaceRegion& region);

}  // namespace exsect
