// The patches that the solution in doubles is given, exactly. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/rational_patch.h>

#include <array>
#include <type_traits>

#include "filter/kind.h"

namespace exsect::filter {

/// Control points of a polynomial patch of bidegree (K::degree,K::degree), row index = first parameter.
template <class K>
struct ElevatedPatch {
  std::array<Point, K::count> points;
};
template <class K>
using ExactPatch = std::conditional_t<std::is_same_v<K, Biquadratic>, BezierPatch, ElevatedPatch<K>>;

inline const Point& control_point(const BezierPatch& patch, std::size_t i) {
  return patch.net()[i / 3][i % 3];
}
template <class K>
const Point& control_point(const ElevatedPatch<K>& patch, std::size_t i) {
  return patch.points[i];
}

/// The patch with the net of bidegree (K::degree,K::degree). Requires a polynomial patch of no higher
/// degrees.
template <class K>
ElevatedPatch<K> elevated(const RationalPatch& patch) {
  constexpr int n = static_cast<int>(K::degree);
  const RationalPatch net = patch.reduced().elevated(n, n);
  ElevatedPatch<K> result;
  for (std::size_t k = 0; k < K::count; ++k) {
    result.points[k] = net.point(static_cast<int>(k / K::side), static_cast<int>(k % K::side));
  }
  return result;
}

}  // namespace exsect::filter
