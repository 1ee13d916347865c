// A ray and a surface given by its equation: all common points, exact.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/triangular_point.h>
#include <exsect/geometry/implicit_surface.h>

#include <optional>
#include <string>
#include <vector>

namespace exsect {

enum class RayContact {
  transversal,  // the ray crosses the surface
  tangential,   // the direction is tangent to the surface in a regular point
  singular,  // the gradient of the equation, or the normal x_u x x_v of the patch, vanishes: an apex, a pole
};
/// "transversal", ...
const char* name(RayContact contact);

/// The point origin + t direction.
struct RayHit {
  RealAlgebraic t;  // >= 0
  /// 1 if transversal. Of t as a root of F(origin + t direction), F the equation; of the parameters as a
  /// common zero of two planes through the ray; 0 where all of a curve of parameters is the one point.
  int multiplicity;
  RayContact contact;
  /// On a patch, r = u and s = v; empty for an equation, and where there is a curve of them.
  std::optional<TriangularPoint> parameters = {};
};

/// All t in the closed interval; without `to`, all from `from` on. Of a single number where a box, or one
/// nappe, holds one point of a line that lies on the surface, and nothing of it beside that point.
struct RayOverlap {
  RealAlgebraic from;
  std::optional<RealAlgebraic> to;
};

/// Hits, ascending in t, and the parts of the ray on the surface, ascending and disjoint. On an equation
/// there are no hits beside an overlap; on a patch those of other parameters, which may lie in it.
struct RayIntersection {
  std::vector<RayHit> hits;
  std::vector<RayOverlap> overlaps;
  /// Why something may be missing; empty if all points are there.
  std::optional<std::string> incomplete = {};
};

/// All points of the closed ray origin + t direction, t >= 0, on the surface. Throws std::invalid_argument
/// for a direction of length 0.
RayIntersection intersect_ray(const Point& origin, const Point& direction, const ImplicitSurface& surface);

}  // namespace exsect
