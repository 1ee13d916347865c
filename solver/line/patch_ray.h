// A ray and a patch: all common points, exact. docs/method-equations.md, section 17.3.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/surface_ray.h>

namespace exsect {

/// All points of the closed ray origin + t direction, t >= 0, on the patch, of every degree and with weights
/// or without. Throws std::invalid_argument for a direction of length 0. Incomplete where the patch is a
/// piece of the ray's line, and in the rare case of quotient_at (algebra/algebraic_value.h).
RayIntersection intersect_ray(const Point& origin, const Point& direction, const RationalPatch& patch);

}  // namespace exsect
