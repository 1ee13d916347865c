// Graph patches (u, v, h(u,v)) and the plane patch (r, s, 0): intersections with known equations h = 0.
#pragma once

#include <exsect/geometry/bezier_patch.h>

namespace exsect::testing {

/// h[i][j] multiplies u^i v^j.
using HeightCoefficients = std::array<std::array<Rational, 3>, 3>;

inline BezierPatch graph_patch(const HeightCoefficients& h) {
  ControlNet c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      c[i][j] = Point{Rational(0), Rational(0), h[i][j]};
    }
  }
  c[1][0][0] = 1;
  c[0][1][1] = 1;
  return BezierPatch::from_power_basis(c);
}

/// origin + u first + v second.
inline BezierPatch plane(const Point& origin, const Point& first, const Point& second) {
  ControlNet c{};
  c[0][0] = origin;
  c[1][0] = first;
  c[0][1] = second;
  return BezierPatch::from_power_basis(c);
}

inline BezierPatch plane_patch() { return graph_patch({}); }

}  // namespace exsect::testing
