// The columns of DF, and the matrix that makes unit vectors of all but one. Internal to solver/;
// docs/method-doubles.md, section 14.2.
#pragma once

#include "filter/tube.h"

namespace exsect::filter {

/// All unknowns but the axis, which is not the scale.
template <class K>
constexpr std::array<std::array<std::size_t, K::rows>, 4> kOthers = [] {
  std::array<std::array<std::size_t, K::rows>, 4> result{};
  for (std::size_t axis = 0; axis < 4; ++axis) {
    for (std::size_t row = 0; row < K::rows; ++row) result[axis][row] = row < axis ? row : row + 1;
  }
  return result;
}();
/// The Taylor coefficient that is column j of DF.
template <class K>
constexpr std::size_t first_order(std::size_t j) {
  return j % 2 == 0 ? kFirst<K> : kSecond;
}

template <class K>
bool within_reach(const Unknowns<K>& p) {
  const bool inside = std::all_of(p.begin(), p.begin() + 4, [](double t) { return std::fabs(t) <= kReach; });
  if constexpr (K::weighted) {
    return inside && p[4] >= kLeastScale && p[4] <= 1;
  } else {
    return inside;
  }
}

/// Rows of the inverse of the matrix with these columns, in plain doubles: any matrix is a legal C.
inline bool invert(const Vec3& a, const Vec3& b, const Vec3& c, std::array<Vec3, 3>& rows) {
  rows = {cross(b, c), cross(c, a), cross(a, b)};
  const double inverse = 1 / dot(a, rows[0]);
  if (!(std::fabs(inverse) < kGreatestInverse)) {
    return false;
  }
  for (Vec3& row : rows) {
    row = inverse * row;
  }
  return true;
}

inline bool invert(const std::array<Vec3, 3>& columns, std::array<Vec3, 3>& rows) {
  return invert(columns[0], columns[1], columns[2], rows);
}
/// By minors of two columns at a time.
inline bool invert(const std::array<Vec4, 4>& columns, std::array<Vec4, 4>& rows) {
  const auto& [a, b, c, d] = columns;
  const Vec<6> first = wedge(a, b), second = wedge(c, d);
  rows = {join(b, second), -1.0 * join(a, second), join(d, first), -1.0 * join(c, first)};
  const double inverse = 1 / dot(a, rows[0]);
  if (!(std::fabs(inverse) < kGreatestInverse)) {
    return false;
  }
  for (Vec4& row : rows) {
    row = inverse * row;
  }
  return true;
}

template <std::size_t N>
inline Vec<N> product(const std::array<Vec<N>, N>& rows, const Vec<N>& v) {
  if constexpr (N == 3) {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
  } else {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v), dot(rows[3], v)};
  }
}

/// F_u, F_v, F_r, F_s and, of weighted patches, F by the scale.
template <class K>
std::array<Row<K>, K::unknowns> columns_of(const Row<K>& xu, const Row<K>& xv, const Row<K>& y,
                                           const Row<K>& yr, const Row<K>& ys, const Unknowns<K>& at) {
  if constexpr (K::weighted) {
    const double scale = -kScaleUnit * at[4];
    return {xu, xv, scale * yr, scale * ys, -kScaleUnit * y};
  } else {
    return {xu, xv, -1.0 * yr, -1.0 * ys};
  }
}

/// The matrix C that makes unit vectors of the columns but the axis.
template <class K>
bool invert_others(const std::array<Row<K>, K::unknowns>& column, std::size_t axis,
                   std::array<Row<K>, K::rows>& c) {
  const auto& others = kOthers<K>[axis];
  std::array<Row<K>, K::rows> chosen;
  for (std::size_t row = 0; row < K::rows; ++row) chosen[row] = column[others[row]];
  return invert(chosen, c);
}

/// How much the scale may change in the region, relative to that of the centre.
template <class K>
double relative_change(const TubeOf<K>& tube) {
  return K::weighted ? tube.offset[K::unknowns - 1] : 0;
}

}  // namespace exsect::filter
