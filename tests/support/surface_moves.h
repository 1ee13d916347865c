// Exact motions of surfaces given by their equations, and their common points on planes by another route.
#pragma once

#include <exsect/solver/intersect_equations.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace exsect::surface_moves {

/// p -> scale (turn p) + shift, with a turn by the quaternion 1 + 2i + 3j + 4k. The scale is positive.
struct Motion {
  Rational scale = 1;
  Point shift = {0, 0, 0};
  bool turns = true;

  Point direction(const Point& d) const;
  Point operator()(const Point& p) const;
  /// Requires a surface other than a polynomial.
  ImplicitSurface operator()(const ImplicitSurface& surface) const;
};

/// With their names: turned, times 25.4, small and far away.
std::vector<std::pair<std::string, Motion>> motions();

/// The points o + s a + t b. Requires a and b that are not parallel.
struct TestPlane {
  Point o;
  Point a;
  Point b;
};

struct PlaneCounts {
  int by_polylines;  // crossings of the plane
  int by_resultant;  // real zeros of the resultant of both equations on the plane
};

/// Common points on a plane in general position. Nothing if the resultant is a constant, or an arc ends or
/// turns back within its error bound of the plane. Both counts are equal for a bounded curve that crosses the
/// plane wherever it meets it, if no two of its points there have the same t.
std::optional<PlaneCounts> plane_counts(const ImplicitSurface& first, const ImplicitSurface& second,
                                        const SurfaceIntersection& result, const TestPlane& plane);

}  // namespace exsect::surface_moves
