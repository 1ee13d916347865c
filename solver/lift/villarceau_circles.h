// Circles of Villarceau that two tori have in common. Internal to solver/; docs/method-equations.md,
// section 17.10.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <vector>

#include "lift/surface_intersection.h"

namespace exsect {

/// Normals of the planes through the common centre that cut both tori in the same two circles.
std::vector<Point> shared_bitangent_planes(const SurfaceData& first, const SurfaceData& second);

/// Names these circles in the complete answer for the two tori, where their arcs belong to `general` curves
/// and are known from their polylines. Sets no ids of curves, and not is_closed.
void name_villarceau_circles(SurfaceIntersection& result, const SurfaceData& first,
                             const SurfaceData& second);

}  // namespace exsect
