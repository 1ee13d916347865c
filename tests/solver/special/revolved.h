// Surfaces of revolution about the axis of z, of rational circular arcs, and rotations of them.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

#include "support/random_nets.h"

namespace exsect::revolved {

/// (w cos, w sin, w); for profiles (w distance, w height, w).
using Arc3 = std::vector<std::array<Rational, 3>>;

/// The unit circle from the angle 2 atan(from) to 2 atan(to).
inline Arc3 arc(const Rational& from, const Rational& to) {
  return {{1 - from * from, 2 * from, 1 + from * from},
          {1 - from * to, from + to, 1 + from * to},
          {1 - to * to, 2 * to, 1 + to * to}};
}

/// The arc of radius |radius| about (distance, 0), from the other side of the circle for radius < 0.
inline Arc3 moved(Arc3 arc, const Rational& radius, const Rational& distance) {
  for (auto& [x, y, w] : arc) {
    x = radius * x + distance * w;
    y = radius * y;
  }
  return arc;
}

inline RationalPatch patch(const Arc3& profile, const Arc3& circle) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const auto& [d, h, w] : profile) {
    net.emplace_back();
    for (const auto& [c, s, t] : circle) net.back().push_back({d * c, d * s, h * t, w * t});
  }
  return RationalPatch::from_homogeneous(net);
}

/// The rotation of the quaternion (a,b,c,d), then the translation.
inline RationalPatch rotated(const RationalPatch& patch, const std::array<int, 4>& q, const Point& by) {
  const auto [a, b, c, d] = q;
  const Rational n = a * a + b * b + c * c + d * d;
  return random_nets::image(
      patch, {{{(a * a + b * b - c * c - d * d) / n, 2 * (b * c - a * d) / n, 2 * (b * d + a * c) / n, by[0]},
               {2 * (b * c + a * d) / n, (a * a - b * b + c * c - d * d) / n, 2 * (c * d - a * b) / n, by[1]},
               {2 * (b * d - a * c) / n, 2 * (c * d + a * b) / n, (a * a - b * b - c * c + d * d) / n, by[2]},
               {0, 0, 0, 1}}});
}

}  // namespace exsect::revolved
