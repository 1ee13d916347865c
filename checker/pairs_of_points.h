// Pairs of points of one patch, next to the diagonal and in charts across it (docs/certificate.md, "Charts").
#pragma once

#include "position.h"

namespace exsect::checker {

/// P and Q, maps of (U, V, a^2, b^2) with the same monomials in the same order: F(U + a, V + b, U - a, V - b)
/// = 2 (a P + b Q) for pairs of points with middle (U,V) and half difference (a,b).
template <class N>
using Divided = std::array<Map<N>, 2>;

/// The parts of c(U + a, V + b), of its coefficients, as maps of (U, V, a^2, b^2): A + a B + b C + a b D.
template <class N, std::size_t dimension>
std::array<Map<N>, 4> parts_by_parity(const Grid<N, dimension>& c) {
  std::array<Map<N>, 4> result;
  c.each([&](std::size_t i, std::size_t j) {
    Vector3<N> entry = {};
    std::copy(c[i][j].begin(), c[i][j].end(), entry.begin());
    for (std::size_t k = 0; k <= i; ++k)
      for (std::size_t l = 0; l <= j; ++l)
        result[k % 2 + 2 * (l % 2)].add({int(i - k), int(j - l), int(k / 2), int(l / 2)}, entry,
                                        N(binomial(i, k) * binomial(j, l)));
  });
  return result;
}

/// Adds sign w_1 x times the monomial, w_1 the first component of w.
template <class N>
void add_product(Map<N>& map, const Map<N>& w, const Map<N>& x, int sign, const Power& monomial = {}) {
  for (const auto& a : w.terms()) {
    for (const auto& b : x.terms()) {
      Power power = monomial;
      for (std::size_t j = 0; j < 4; ++j) power[j] += a.power[j] + b.power[j];
      map.add(power, b.c, N(sign) * a.c[0]);
    }
  }
}
/// Adds the map of (U, V, a^2, b^2) where a = t, b = m t and w = t^2, in (U,V,m,w), times the monomial.
template <class N>
void add_in_chart(Map<N>& chart, const Map<N>& map, const Power& monomial) {
  for (const auto& [power, c, lower] : map.terms())
    chart.add({power[0], power[1], 2 * power[3] + monomial[2], power[2] + power[3] + monomial[3]}, c, N(1));
}

template <class N>
Divided<N> with_common_monomials(const Divided<N>& maps) {
  Map<N> all;
  for (const Map<N>& map : maps)
    for (const auto& term : map.terms()) all.coefficient(term.power);
  Divided<N> result = {all, all};
  for (std::size_t n = 0; n < 2; ++n)
    for (const auto& term : maps[n].terms()) result[n].coefficient(term.power) = term.c;
  return result;
}

/// A chart of the pairs of points of one patch.
template <class N>
struct PairChart {
  Divided<N> divided;
  Map<N> equation;  // H(U,V,m,w): F(U + t, V + m t, U - t, V - m t) = 2 t H for w = t^2, docs/method.md (7.2)
  Position<N> space;  // where both points are one, both of them
};

/// Of the coefficients. With the parts of X and, in small letters, of its weights
///     P = a B - b A + b^2 (d C - c D),     Q = a C - c A + a^2 (d B - b D).
template <class N>
PairChart<N> pair_chart(const WeightedNet<N>& net) {
  PairChart<N> result;
  const auto x = parts_by_parity(net.points);
  const auto w = parts_by_parity(net.weights);
  for (const std::size_t p : {std::size_t{1}, std::size_t{2}}) {  // the odd part of P or Q, and the other one
    Map<N>& map = result.divided[p - 1];
    Power square = {};
    square[4 - p] = 1;
    add_product(map, w[0], x[p], 1);
    add_product(map, w[p], x[0], -1);
    add_product(map, w[3], x[3 - p], 1, square);
    add_product(map, w[3 - p], x[3], -1, square);
    add_in_chart(result.equation, map, {0, 0, static_cast<int>(p) - 1, 0});
  }
  result.divided = with_common_monomials(result.divided);
  const auto mean = [&](const std::array<Map<N>, 4>& parts) {
    Map<N> map;
    add_in_chart(map, parts[0], {});
    add_in_chart(map, parts[3], {0, 0, 1, 1});
    return map;
  };
  result.space.points = mean(x);
  if (net.has_weights()) result.space.weight = mean(w);
  return result;
}
template <class N>
PairChart<N> rounded(const PairChart<Rational>& chart) {
  return {{rounded<N>(chart.divided[0]), rounded<N>(chart.divided[1])},
          rounded<N>(chart.equation),
          rounded<N>(chart.space)};
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

/// The squares.
template <class N>
Ball<N> square(const Ball<N>& a) {
  const N most = a.magnitude() * a.magnitude();
  const N least = a.sign() != 0 ? N(a.least() * a.least()) : N(0);
  const N middle = N(0.5) * (most + least);
  return {middle, N(most - middle)};
}

/// P and Q over a box of pairs (U,V,a,b).
template <class N>
class DividedOver {
 public:
  DividedOver(const Divided<N>& maps, const Box<N>& pairs)
      : DividedOver(Box<N>{pairs[0], pairs[1], square(pairs[2]), square(pairs[3])}, maps) {}

  Balls<N> q() const { return Ranges(q_, half_).value(); }
  /// R = P + m Q, the coefficients added up first.
  Balls<N> r(const N& m) const {
    Map<N> sum = p_;
    sum.add(q_, m);
    return Ranges(sum, half_).value();
  }

 private:
  DividedOver(const Box<N>& squares, const Divided<N>& maps)
      : p_(maps[0].at(middles(squares))), q_(maps[1].at(middles(squares))), half_(radii(squares)) {}

  Map<N> p_;
  Map<N> q_;
  Vector4<N> half_;
};

/// Where a P + b Q = 0 for pairs of the box, (U,V,m,a^2) for m = b/a: with n the third row of C, m = m0 -
/// (n . R) / (n . Q) for any m0, and a = 0 would make b = 0. Nothing is known, which the radius says, where
/// n . Q may vanish.
template <class N>
Box<N> pairs_in_chart(const Tube<N>& tube, const Divided<N>& maps, const Box<N>& pairs) {
  const N& m = tube.centre[2];
  const DividedOver<N> over({maps[0].times(tube.inverse), maps[1].times(tube.inverse)}, pairs);
  const Balls<N> r = over.r(m);
  const Balls<N> q = over.q();
  return {pairs[0], pairs[1], q[2].sign() == 0 ? Ball<N>(m, tube.extent()[2] + 1) : m - r[2] / q[2],
          square(pairs[2])};
}

/// n . (P x Q) of the first chart: if it does not vanish, no different points of the box are one in space.
template <class N>
Ball<N> volume(const Vector3<N>& n, const Divided<N>& maps, const Box<N>& pairs) {
  const DividedOver<N> over(maps, pairs);
  const Balls<N> p = over.r(0);
  const Balls<N> q = over.q();
  double pq = 0;
  double qq = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    pq += approximate(p[d].middle) * approximate(q[d].middle);
    qq += approximate(q[d].middle) * approximate(q[d].middle);
  }
  // P x Q = R x Q: of all m, the one for which R is short.
  const Balls<N> r = over.r(qq > 0 && std::abs(pq) < 1e6 * qq ? N(-pq / qq) : N(0));
  return dot(Balls<N>{n[0], n[1], n[2]}, cross(r, q));
}

}  // namespace exsect::checker
