// Bounds for a curve F = 0 near a point (docs/certificate.md, "Tubes"), F a polynomial map of four variables
// to space. Over Q, and in Enclosure, they prove; over doubles they let a writer look for claims.
//
// Notation: w the four variables, k the axis of a tube, the curve is a graph over w_k; C its inverse, a 3 x 3
// matrix near the inverse of the columns of DF other than k. Row i of C F belongs to the variable
// others(k)[i].
#pragma once

#include "map.h"

namespace exsect::checker {

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
  std::size_t axis;
  Vector4<N> slope;
  N reach;
  N width;
  Matrix3<N> inverse;
  int line = -1;  // the exact solution that the curve is; -1 if none is claimed
  int seam = -1;  // what proves that there is nothing else, instead of the inverse

  /// Half extents of the box around the tube.
  Vector4<N> extent() const {
    Vector4<N> h;
    for (std::size_t i = 0; i < 4; ++i) h[i] = magnitude(slope[i]) * reach + (i == axis ? N(0) : width);
    return h;
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

/// Row sums of |C D'F - 1| over a box, D' without the column k.
template <class N>
Vector3<N> defects(const Map<N>& local, std::size_t axis, const Vector4<N>& h) {
  Vector3<N> row = {};
  for (std::size_t d = 0; d < 3; ++d) {
    for (std::size_t j = 0; j < 3; ++j) {
      Ball<N> entry = local.first(d, others(axis)[j], h);
      if (j == d) entry.middle -= 1;
      row[d] += entry.magnitude();
    }
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
  const Vector3<N> e = defects(local, tube.axis, tube.extent());
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
  const Vector3<N> row = defects(local, axis, h);
  for (const N& r : row) result.defect = larger(result.defect, r);
  if (!(result.defect < 1)) return result;
  // (1 + E) w' = g with |E| <= row: |w'| <= max|g| / (1 - defect) and |w' - g| <= row |w'|.
  const auto solve = [&](const std::array<Ball<N>, 3>& g, Box<N>& w) {
    N most = 0;
    for (const Ball<N>& b : g) most = larger(most, b.magnitude());
    most = most / (1 - result.defect);
    for (std::size_t d = 0; d < 3; ++d) w[others(axis)[d]] = {g[d].middle, g[d].radius + row[d] * most};
  };
  std::array<Ball<N>, 3> g;
  result.first[axis] = {1, 0};
  for (std::size_t d = 0; d < 3; ++d) g[d] = -local.first(d, axis, h);
  solve(g, result.first);
  for (std::size_t d = 0; d < 3; ++d) g[d] = -local.second(d, result.first, h);
  solve(g, result.second);
  return result;
}

/// In a chart: u, v, r and s are monotone on the curve wherever 0 < w < `end`, a bound for w in the tube:
/// with t^2 = w, 1 > 2t |U'| and |m| > 2t |V'| + 2w |m'|, docs/method.md (7.6).
template <class N>
bool monotone_pairs(const Tube<N>& tube, const CurveBounds<N>& bounds, const N& end) {
  const N first = bounds.first[0].magnitude();
  const N second = bounds.first[1].magnitude();
  const N rest = magnitude(tube.centre[2]) - tube.extent()[2] - 2 * end * bounds.first[2].magnitude();
  return tube.axis == 3 && end > 0 && rest > 0 && 4 * end * first * first < 1 &&
         4 * end * second * second < rest * rest;
}

/// The pairs of the box as midpoint (U,V) and half difference (a,b); in the chart `second` with u and v
/// exchanged.
template <class N>
Box<N> halves(Chart chart, Box<N> w) {
  if (chart == Chart::second) w = {w[1], w[0], w[3], w[2]};
  const Ball<N> half = {N(0.5), N(0)};
  return {half * (w[0] + w[2]), half * (w[1] + w[3]), half * (w[0] - w[2]), half * (w[1] - w[3])};
}

/// R = P + m Q and Q where x(U + a, V + b) - x(U - a, V - b) = 2 (a P + b Q): P = x_u + b^2/2 x_uvv, Q = x_v
/// + a^2/2 x_uuv at (U,V), `pairs` = (U,V,a,b), for any m. `h`: the map of the chart, or its product with C.
template <class N>
std::array<std::array<Ball<N>, 3>, 2> divided(const Map<N>& h, const Box<N>& pairs, const N& m) {
  const auto& [u, v, a, b] = pairs;
  const Map<N> local = h.at({u.middle, v.middle, N(0), N(0)});
  const Map<N> turned = local.at({N(0), N(0), m, N(0)});
  const Vector4<N> half = {u.radius, v.radius, N(0), N(0)};
  std::array<std::array<Ball<N>, 3>, 2> result;
  for (std::size_t d = 0; d < 3; ++d) {
    const Ball<N> bend = a * a * local.derivative(d, {0, 0, 1, 1}, half);
    result[0][d] = turned.derivative(d, {0, 0, 0, 0}, half) + Ball<N>{m, N(0)} * bend +
                   Ball<N>{N(0.5), N(0)} * b * b * local.derivative(d, {0, 0, 2, 1}, half);
    result[1][d] = local.derivative(d, {0, 0, 1, 0}, half) + bend;
  }
  return result;
}

/// Where a P + b Q = 0 for pairs of the box, (U,V,m,a^2) for m = b/a: with n the third row of C, m = m0 -
/// (n . R) / (n . Q) for any m0, and a = 0 would make b = 0. Nothing is known, which the radius says, where
/// n . Q may vanish.
template <class N>
Box<N> pairs_in_chart(const Tube<N>& tube, const Map<N>& h, const Box<N>& pairs) {
  const N& m = tube.centre[2];
  const auto [r, q] = divided(h.times(tube.inverse), pairs, m);
  const bool any = q[2].sign() == 0;
  const N most = pairs[2].magnitude() * pairs[2].magnitude();
  const N least = pairs[2].sign() != 0 ? N(pairs[2].least() * pairs[2].least()) : N(0);
  const N middle = N(0.5) * (most + least);
  return {pairs[0],
          pairs[1],
          any ? Ball<N>{m, tube.width + 1} : Ball<N>{m, N(0)} - r[2] / q[2],
          {middle, N(most - middle)}};
}

/// n . (P x Q), `h` the map of the first chart: if it does not vanish, no different points of the box are one
/// in space.
template <class N>
Ball<N> volume(const Vector3<N>& n, const Map<N>& h, const Box<N>& pairs) {
  const auto [p, q] = divided(h, pairs, N(0));
  double pq = 0;
  double qq = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    pq += approximate(p[d].middle) * approximate(q[d].middle);
    qq += approximate(q[d].middle) * approximate(q[d].middle);
  }
  // P x Q = R x Q: of all m, the one for which R is short.
  const auto r = divided(h, pairs, qq > 0 && std::abs(pq) < 1e6 * qq ? N(-pq / qq) : N(0))[0];
  Ball<N> result;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t e = (d + 1) % 3;
    const std::size_t f = (d + 2) % 3;
    result = result + Ball<N>{n[d], N(0)} * (r[e] * q[f] - r[f] * q[e]);
  }
  return result;
}

}  // namespace exsect::checker
