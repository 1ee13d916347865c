// Spheres and tori of weighted quarter circles (1, 1, 2).
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

namespace exsect::testing {

/// (w cos, w sin, w) of a quarter of a circle, angle 0 at the parameter 1/2: the quarter (1 - t²), 2 t turned
/// back by the angle whose cosine is 3/5.
using ArcVector = std::array<Rational, 3>;
inline std::array<ArcVector, 3> arc() {
  const std::array<std::array<long, 3>, 3> quarter = {{{1, 0, 1}, {1, 1, 1}, {0, 2, 2}}};
  std::array<ArcVector, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [x, y, w] = quarter[i];
    result[i] = {Rational(3 * x + 4 * y, 5), Rational(3 * y - 4 * x, 5), Rational(w)};
  }
  return result;
}

/// ((major + minor cos a) cos b, (major + minor cos a) sin b, minor sin a): for major 0 a sphere.
inline RationalPatch torus(const Rational& major, const Rational& minor) {
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (const ArcVector& b : arc()) {
      const ArcVector a = arc()[i];
      const Rational radius = major * a[2] + minor * a[0];
      net[i].push_back({radius * b[0], radius * b[1], minor * a[1] * b[2], a[2] * b[2]});
    }
  return RationalPatch::from_homogeneous(net);
}
inline RationalPatch sphere(const Rational& radius) { return torus(0, radius); }

}  // namespace exsect::testing
