// Other preimages of a point of a patch, by brute force.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace exsect {

/// A point of the square with the image of w that is none of the known ones: Newton's method (Gauss's for
/// three equations) from random points. Empty if none is found.
inline std::optional<std::array<double, 2>> preimage_apart_from(
    const BezierPatch& x, const std::array<Rational, 2>& w, const std::vector<std::array<Rational, 2>>& known,
    std::mt19937_64& random) {
  const Point target = x(w[0], w[1]);
  for (int start = 0; start < 12; ++start) {
    double u = static_cast<double>(random() % 1000) / 999;
    double v = static_cast<double>(random() % 1000) / 999;
    double size = 1;
    for (int step = 0; step < 30 && std::isfinite(u + v) && std::fabs(u) + std::fabs(v) < 9; ++step) {
      const Rational at_u = from_double(u);
      const Rational at_v = from_double(v);
      const Point d = x(at_u, at_v) - target;
      const Point a = x.derivative_first(at_u, at_v);
      const Point b = x.derivative_second(at_u, at_v);
      const double aa = to_double(dot(a, a));
      const double ab = to_double(dot(a, b));
      const double bb = to_double(dot(b, b));
      const double ad = to_double(dot(a, d));
      const double bd = to_double(dot(b, d));
      const double det = aa * bb - ab * ab;
      u -= (bb * ad - ab * bd) / det;
      v -= (aa * bd - ab * ad) / det;
      size = std::sqrt(to_double(dot(d, d)));
    }
    if (!(size < 1e-13) || !(u >= 0 && u <= 1 && v >= 0 && v <= 1)) continue;
    bool expected = false;
    for (const auto& q : known)
      expected = expected || std::hypot(u - to_double(q[0]), v - to_double(q[1])) < 1e-4;
    if (!expected) return {{u, v}};
  }
  return std::nullopt;
}

}  // namespace exsect
