// What two boxes of one surface share. Internal to solver/; docs/method-equations.md, section 17.12.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <optional>
#include <vector>

namespace exsect {

/// The points of the surface on another one, in a region.
struct SharedCut {
  ImplicitSurface surface;
  SurfaceRegion region = {};
};

/// Invariant: what the boxes share is the closure of its inner points, if it has any, and the cuts in both
/// boxes, no two of which have a point in common.
struct SharedBox {
  bool has_inner_points = false;
  std::vector<SharedCut> cuts = {};
};

/// Of two surfaces with one set of points but for boxes and nappes. Empty for boxes about different axes of a
/// sphere (sphere_boxes.h). Requires that one of them at least is no polynomial, if there is a box.
std::optional<SharedBox> shared_box(const ImplicitSurface& first, const ImplicitSurface& second);

}  // namespace exsect
