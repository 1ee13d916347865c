// Two round surfaces whose curve doubles decide. Internal to solver/; docs/method-equations.md,
// section 17.21.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <functional>
#include <optional>

#include "lift/surface_intersection.h"

namespace exsect {

/// The common points, if they are bounded, none of them is singular, and no part of the curve is a conic;
/// empty if doubles do not prove that, and if a surface has a box. `tolerance` of an extent is how near
/// polylines have to be.
std::optional<SurfaceIntersection> round_intersection(const ImplicitSurface& first,
                                                      const ImplicitSurface& second,
                                                      const std::function<double(double)>& tolerance);

}  // namespace exsect
