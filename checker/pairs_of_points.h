// Pairs of points of one patch, next to the diagonal and in charts across it (docs/certificate.md, "Charts").
#pragma once

#include "curve_bounds.h"

namespace exsect::checker {

/// H(U,V,m,w): x(U + t, V + m t) - x(U - t, V - m t) = 2 t H for w = t^2, docs/method.md (7.3).
template <class N>
Map<N> chart_map(const Net<N>& c) {
  Map<N> map;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector3<N>& point = c[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      if (i > 0) map.add({i - 1, j, 0, 0}, point, N(i));
      if (j > 0) map.add({i, j - 1, 1, 0}, point, N(j));
      if (i == 2 && j > 0) map.add({0, j - 1, 1, 1}, point, N(j));
      if (j == 2 && i > 0) map.add({i - 1, 0, 2, 1}, point, N(i));
    }
  }
  return map;
}
/// The mean of x(U + t, V + m t) and x(U - t, V - m t), (7.4).
template <class N>
Map<N> chart_space(const Net<N>& c) {
  Map<N> map;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector3<N>& point = c[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      map.add({i, j, 0, 0}, point, N(1));
      if (i > 0 && j > 0) map.add({i - 1, j - 1, 1, 1}, point, N(i * j));
      if (i == 2) map.add({0, j, 0, 1}, point, N(1));
      if (j == 2) map.add({i, 0, 2, 1}, point, N(1));
      if (i == 2 && j == 2) map.add({0, 0, 2, 2}, point, N(1));
    }
  }
  return map;
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
  const Ball<N> half = N(0.5);
  return {half * (w[0] + w[2]), half * (w[1] + w[3]), half * (w[0] - w[2]), half * (w[1] - w[3])};
}

/// R = P + m Q and Q where x(U + a, V + b) - x(U - a, V - b) = 2 (a P + b Q): P = x_u + b^2/2 x_uvv, Q = x_v
/// + a^2/2 x_uuv at (U,V), `pairs` = (U,V,a,b), for any m. `h`: the map of the chart, or its product with C.
template <class N>
std::array<Balls<N>, 2> divided(const Map<N>& h, const Box<N>& pairs, const N& m) {
  const auto& [u, v, a, b] = pairs;
  const Map<N> local = h.at({u.middle, v.middle, N(0), N(0)});
  const Map<N> turned = local.at({N(0), N(0), m, N(0)});
  const Vector4<N> half = {u.radius, v.radius, N(0), N(0)};
  const Balls<N> x_u = turned.derivative({}, half);  // and m x_v
  const Balls<N> x_v = local.derivative({0, 0, 1, 0}, half);
  const Balls<N> x_uuv = local.derivative({0, 0, 1, 1}, half);  // one half of it, as x_uvv
  const Balls<N> x_uvv = local.derivative({0, 0, 2, 1}, half);
  std::array<Balls<N>, 2> result;
  for (std::size_t d = 0; d < 3; ++d) {
    const Ball<N> bend = a * a * x_uuv[d];
    result[0][d] = x_u[d] + m * bend + N(0.5) * b * b * x_uvv[d];
    result[1][d] = x_v[d] + bend;
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
          any ? Ball<N>(m, tube.extent()[2] + 1) : m - r[2] / q[2],
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
  return dot(Balls<N>{n[0], n[1], n[2]}, cross(r, q));
}

}  // namespace exsect::checker
