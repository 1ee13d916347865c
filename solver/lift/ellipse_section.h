// Ellipses in which a plane cuts a sphere, a cylinder or a cone, and in which two spheres meet, without a
// shadow. Internal to solver/; docs/method-equations.md, section 17.18.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <functional>
#include <optional>

#include "lift/pair_region.h"
#include "lift/surface_intersection.h"

namespace exsect {

/// The points centre + x along + y across with x^2 / along_reach + y^2 / across_reach = 1. Both directions
/// are orthogonal, both numbers > 0.
struct EllipseSection {
  Point centre;
  Point along;
  Point across;
  Rational along_reach;
  Rational across_reach;
};

/// All common points of the whole surfaces, with both nappes. Empty if they are no ellipse, and of other
/// kinds.
std::optional<EllipseSection> ellipse_section(const ImplicitSurface& first, const ImplicitSurface& second);

/// Two nodes where y = 0 and the halves between them. `tolerance` of an extent is how near polylines have to
/// be.
SurfaceIntersection drawn(const EllipseSection& ellipse, const std::function<double(double)>& tolerance);

/// The intersection in the region if that has no other bounds than nappes; empty as ellipse_section() is, and
/// then nothing is said.
std::optional<SurfaceIntersection> ellipse_intersection(const ImplicitSurface& first,
                                                        const ImplicitSurface& second,
                                                        const PairRegion& region,
                                                        const std::function<double(double)>& tolerance);

}  // namespace exsect
