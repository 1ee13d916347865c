// Graph patches (u, v, h(u,v)) and the plane patch (r, s, 0): intersections with known equations h = 0.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <map>
#include <utility>

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

/// A polynomial by its coefficients of u^i v^j.
struct Terms : std::map<std::pair<std::size_t, std::size_t>, Rational> {
  using map::map;
};
inline Terms operator*(const Terms& a, const Terms& b) {
  Terms product;
  for (const auto& [i, p] : a)
    for (const auto& [j, q] : b) product[{i.first + j.first, i.second + j.second}] += p * q;
  return product;
}
inline Terms operator+(Terms a, const Terms& b) {
  for (const auto& [i, p] : b) a[i] += p;
  return a;
}

/// (u, v, h), of degree two at most in each parameter.
inline BezierPatch graph(const Terms& h) {
  HeightCoefficients heights{};
  for (const auto& [i, p] : h) heights[i.first][i.second] += p;
  return graph_patch(heights);
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
