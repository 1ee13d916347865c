// Bounds for a curve F = 0 near a point (docs/certificate.md, "Tubes"), F a polynomial map of four variables
// to space. Over Q, and in Enclosure, they prove; over doubles they let a writer look for claims.
//
// Notation: w the four variables, k the axis of a tube, the curve is a graph over w_k; C its inverse, a 3 x 3
// matrix near the inverse of the columns of DF other than k. Row i of C F belongs to the variable
// others(k)[i].
#pragma once

#include "map.h"

namespace exsect::checker {

/// One of u, v, r, s: 0, ..., 3.
struct Parameter {
  std::size_t index = 0;
  operator std::size_t() const { return index; }
};

/// Which map is F, and in which variables.
enum class Chart {
  pair,    // x(u,v) - y(r,s); of one patch x(u,v) - x(r,s)
  first,   // H of a patch: (U,V,m,w)
  second,  // H of the patch with u and v exchanged
  star,    // F next to a point: a chart of a star
};

/// One of the maps that certificates speak of.
struct MapName {
  Chart chart = Chart::pair;
  std::size_t star = 0;  // of Chart::star, and which of its eight charts
  std::size_t direction = 0;

  bool operator==(const MapName&) const = default;
};

/// The set of all centre + t slope + e, |t| <= reach, |e_i| <= width, e_k = 0; slope_k = 1.
template <class N>
struct Tube : MapName {
  Vector4<N> centre;
  Parameter axis;
  Vector4<N> slope;
  N reach;
  N width;
  Matrix3<N> inverse;
  int factor = -1;  // of F, whose map it is one of; -1 if it is one of F itself

  /// Half extents of the box around the tube.
  Vector4<N> extent() const {
    Vector4<N> h;
    for (std::size_t i = 0; i < 4; ++i) h[i] = magnitude(slope[i]) * reach + (i == axis ? N(0) : width);
    return h;
  }
  /// The box lies in the one around the tube, in which no other zeros are than those of the tube.
  bool surrounds(const Box<N>& w) const {
    const Vector4<N> h = extent();
    for (std::size_t i = 0; i < 4; ++i)
      if (!(magnitude(N(w[i].middle - centre[i])) + w[i].radius <= h[i])) return false;
    return true;
  }
  /// The box lies in the tube.
  bool contains(const Box<N>& w) const {
    const N t = w[axis].middle - centre[axis];
    if (!(magnitude(t) + w[axis].radius <= reach)) return false;
    for (const std::size_t i : others(axis)) {
      const N off = w[i].middle - centre[i] - slope[i] * t;
      if (!(magnitude(off) + w[i].radius + magnitude(slope[i]) * w[axis].radius <= width)) return false;
    }
    return true;
  }
};

/// Row sums of |C D'F - 1| over a box, D' without the column k, from the derivatives of C F.
template <class N>
Vector3<N> defects(const Ranges<N>& over, std::size_t axis) {
  Vector3<N> row = {};
  for (std::size_t j = 0; j < 3; ++j) {
    Balls<N> column = over.first(others(axis)[j]);
    column[j].middle -= 1;
    for (std::size_t d = 0; d < 3; ++d) row[d] += column[d].magnitude();
  }
  return row;
}

/// width - f - E width row by row, `local` the map at the centre times C. If all three are > 0, then for
/// every t there is exactly one zero of F in the tube.
template <class N>
Vector3<N> contraction(const Tube<N>& tube, const Map<N>& local) {
  std::vector<Vector3<N>> p;  // C F(centre + t slope) = p_0 + p_1 t + ...
  for (const auto& term : local.terms()) {
    N factor = 1;
    int degree = 0;
    for (std::size_t j = 0; j < 4; ++j, degree += term.power[j - 1])
      for (int i = 0; i < term.power[j]; ++i) factor = factor * tube.slope[j];
    const auto m = static_cast<std::size_t>(degree);
    if (p.size() <= m) p.resize(m + 1);
    for (std::size_t d = 0; d < 3; ++d) p[m][d] += factor * term.c[d];
  }
  const Vector3<N> e = defects(Ranges(local, tube.extent()), tube.axis);
  Vector3<N> result;
  for (std::size_t d = 0; d < 3; ++d) {
    N f = 0;
    for (std::size_t m = p.size(); m-- > 0;) f = magnitude(p[m][d]) + tube.reach * f;
    result[d] = tube.width - f - e[d] * tube.width;
  }
  return result;
}

/// Derivatives of the curve with respect to w_k wherever it lies in a box |dw_i| <= h_i, as enclosures.
template <class N>
struct CurveBounds {
  N defect;  // >= all row sums; nothing is known unless it is < 1
  Box<N> first;
  Box<N> second;
};

/// `local`: the map at the middle of the box times C.
template <class N>
CurveBounds<N> curve_bounds(const Map<N>& local, std::size_t axis, const Vector4<N>& h) {
  CurveBounds<N> result{};
  const Ranges over(local, h);
  const Vector3<N> row = defects(over, axis);
  for (const N& r : row) result.defect = larger(result.defect, r);
  if (!(result.defect < 1)) return result;
  // (1 + E) w' = g with |E| <= row: |w'| <= max|g| / (1 - defect) and |w' - g| <= row |w'|.
  const auto solve = [&](const Balls<N>& minus_g, Box<N>& w) {
    N most = 0;
    for (const Ball<N>& b : minus_g) most = larger(most, b.magnitude());
    most = most / (1 - result.defect);
    for (std::size_t d = 0; d < 3; ++d)
      w[others(axis)[d]] = {-minus_g[d].middle, minus_g[d].radius + row[d] * most};
  };
  result.first[axis] = N(1);
  solve(over.first(axis), result.first);
  solve(over.second(result.first), result.second);
  return result;
}

/// A box that holds the tube's curve between two places, each within `margin` of it, and margin further.
/// Monotone parameters are in the hull of both ends on the curve. Others, `open`, leave the chord on a step d
/// of the axis by at most d/2 times the radius of a ball that holds their derivatives, and d^2/8 times a
/// bound of the second ones; so do the variables of a chart.
template <class N>
Box<N> around_chord(const Tube<N>& tube, const CurveBounds<N>& bounds, const Vector4<N>& a,
                    const Vector4<N>& b, const N& margin, const std::array<bool, 4>& open) {
  Box<N> result;
  const N step = magnitude(N(a[tube.axis] - b[tube.axis])) / 2;
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] = {(a[i] + b[i]) / 2, magnitude(N(a[i] - b[i])) / 2 + 2 * margin};
    if (tube.chart != Chart::pair) {
      result[i].radius += step * bounds.first[i].radius;
    } else if (open[i]) {
      const N longer = step + margin;
      result[i].radius +=
          smaller(N(longer * bounds.first[i].radius), N(longer * longer / 2 * bounds.second[i].magnitude()));
    }
  }
  return result;
}

/// A matrix near the inverse of the columns of DF other than the axis at the point: any matrix will do if
/// the defect comes out below 1.
template <class N>
Matrix3<N> near_inverse(const Map<N>& local, std::size_t axis) {
  std::array<Vector3<double>, 3> column;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector3<N> c = local.slope(others(axis)[j]);
    column[j] = {approximate(c[0]), approximate(c[1]), approximate(c[2])};
  }
  const auto& [a, b, c] = column;
  const Matrix3<double> adjugate = {cross(b, c), cross(c, a), cross(a, b)};
  const double det = dot(a, adjugate[0]);
  Matrix3<N> result;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t d = 0; d < 3; ++d)
      if (const double entry = adjugate[j][d] / det; std::isfinite(entry)) result[j][d] = N(entry);
  return result;
}

/// Bounds over a box for the curve of the map there, with a matrix near the inverse at its middle.
template <class N>
CurveBounds<N> bounds_over(const Map<N>& map, std::size_t axis, const Vector4<N>& middle,
                           const Vector4<N>& half) {
  const Map<N> here = map.at(middle);
  return curve_bounds(here.times(near_inverse(here, axis)), axis, half);
}

/// The signs of the derivatives on a curve in a box with the bounds `over`, all of it at most `length` along
/// the axis from its point within `near` of `at`; 0 where none is found. From there each derivative changes
/// by at most length times a bound of the second one.
template <class N>
std::array<int, 4> slope_signs(const Map<N>& map, std::size_t axis, const CurveBounds<N>& over,
                               const Vector4<N>& at, const N& near, const N& length) {
  std::array<int, 4> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = over.first[i].sign();
  if (std::find(result.begin(), result.end(), 0) == result.end()) return result;
  const CurveBounds<N> there = bounds_over(map, axis, at, {near, near, near, near});
  for (std::size_t i = 0; i < 4 && there.defect < 1; ++i) {
    const Ball<N> all(there.first[i].middle, there.first[i].radius + length * over.second[i].magnitude());
    if (result[i] == 0) result[i] = all.sign();
  }
  return result;
}

}  // namespace exsect::checker
