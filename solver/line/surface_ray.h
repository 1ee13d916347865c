// A ray and a surface given by its equation: all common points, exact.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/implicit_surface.h>

#include <optional>
#include <vector>

namespace exsect {

enum class RayContact {
  transversal,  // the ray crosses the surface
  tangential,   // the direction is tangent to the surface in a regular point of the equation
  singular,     // the gradient of the equation vanishes: the apex of a cone
};

/// The point origin + t direction.
struct RayHit {
  RealAlgebraic t;   // >= 0
  int multiplicity;  // of t as a root of F(origin + t direction), F the equation
  RayContact contact;
};

/// All t in the closed interval; without `to`, all from `from` on.
struct RayOverlap {
  RealAlgebraic from;
  std::optional<RealAlgebraic> to;
};

/// Either hits, ascending in t, or a part of the ray that lies on the surface and all of their common points.
struct RayIntersection {
  std::vector<RayHit> hits;
  std::optional<RayOverlap> overlap;
};

/// All points of the closed ray origin + t direction, t >= 0, on the surface. Throws std::invalid_argument
/// for a direction of length 0.
RayIntersection intersect_ray(const Point& origin, const Point& direction, const ImplicitSurface& surface);

}  // namespace exsect
