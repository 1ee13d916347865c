// Bounds for a curve F = 0 near a point (docs/certificate.md, "Tubes"), F a polynomial map of four variables
// to space. Over Q, and in Enclosure, they prove; over doubles they let a writer look for claims.
//
// Notation: w the four variables, k the axis of a tube, the curve is a graph over w_k; C its inverse, a 3 x 3
// matrix near the inverse of the columns of DF other than k. Row i of C F belongs to the variable
// others(k)[i].
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "enclosure.h"

namespace exsect::checker {

template <class N>
using Vector4 = std::array<N, 4>;
template <class N>
using Vector3 = std::array<N, 3>;
template <class N>
using Matrix3 = std::array<std::array<N, 3>, 3>;
/// c[i][j] is the vector coefficient of u^i v^j, or a control point.
template <class N>
using Net = std::array<std::array<Vector3<N>, 3>, 3>;

template <class N>
N magnitude(const N& a) {
  return a < 0 ? N(-a) : a;
}
template <class N>
const N& larger(const N& a, const N& b) {
  return a < b ? b : a;
}

/// -1, 0, 1.
template <class N>
int sign_of(const N& a) {
  return a > 0 ? 1 : a < 0 ? -1 : 0;
}
template <class N>
N dot(const Vector3<N>& a, const Vector3<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// All numbers within `radius` of `middle`.
template <class N>
struct Ball {
  N middle{};
  N radius{};

  N magnitude() const { return checker::magnitude(middle) + radius; }
  /// A lower bound of |a|; not positive if 0 may be in the ball.
  N least() const { return checker::magnitude(middle) - radius; }
  /// -1 or 1 if all numbers of the ball have this sign, else 0.
  int sign() const { return middle > radius ? 1 : middle < -radius ? -1 : 0; }
  friend Ball operator+(const Ball& a, const Ball& b) { return {a.middle + b.middle, a.radius + b.radius}; }
  friend Ball operator-(const Ball& a, const Ball& b) { return {a.middle - b.middle, a.radius + b.radius}; }
  friend Ball operator-(const Ball& a) { return {-a.middle, a.radius}; }
  friend Ball operator*(const Ball& a, const Ball& b) {
    return {a.middle * b.middle, checker::magnitude(a.middle) * b.radius + a.radius * b.magnitude()};
  }
  /// For b.sign() != 0: |a/b - q| = |a - q b| / |b|, q the quotient of the middles.
  friend Ball operator/(const Ball& a, const Ball& b) {
    const N q = a.middle / b.middle;
    return {q, (a.radius + checker::magnitude(q) * b.radius) / b.least()};
  }
};
template <class N>
using Box = std::array<Ball<N>, 4>;

/// The three variables other than k, in order.
inline std::array<std::size_t, 3> others(std::size_t k) {
  return {k == 0 ? std::size_t{1} : 0, k <= 1 ? std::size_t{2} : 1, k <= 2 ? std::size_t{3} : 2};
}

using Power = std::array<int, 4>;

/// A polynomial map of degree at most 2 in each variable, by its Taylor coefficients at a point.
template <class N>
class Map {
 public:
  struct Term {
    Power power;
    Vector3<N> c;
  };
  const std::vector<Term>& terms() const { return terms_; }

  /// The coefficient of a monomial; with each monomial there are all that divide it, 1 the first.
  Vector3<N>& coefficient(const Power& power) {
    for (Term& term : terms_)
      if (term.power == power) return term.c;
    for (std::size_t j = 0; j < 4; ++j) {
      Power lower = power;
      if (--lower[j] >= 0) coefficient(lower);
    }
    return terms_.emplace_back(Term{power, {}}).c;
  }
  void add(const Power& power, const Vector3<N>& c, const N& factor) {
    Vector3<N>& sum = coefficient(power);
    for (std::size_t d = 0; d < 3; ++d) sum[d] += factor * c[d];
  }

  /// The Taylor coefficients at another point, w further.
  Map at(const Vector4<N>& w) const {
    Map result = *this;
    for (Term& lower : result.terms_) {
      for (const Term& term : terms_) {
        int binomial = term.power == lower.power ? 0 : 1;
        for (std::size_t j = 0; j < 4; ++j)
          binomial *= term.power[j] < lower.power[j] ? 0 : term.power[j] == 2 && lower.power[j] == 1 ? 2 : 1;
        if (binomial == 0) continue;
        const N factor = product(binomial, w, term.power, lower.power);
        for (std::size_t d = 0; d < 3; ++d) lower.c[d] += factor * term.c[d];
      }
    }
    return result;
  }
  Vector3<N> value(const Vector4<N>& w) const {
    Vector3<N> sum = {};
    for (const Term& term : terms_) {
      const N factor = product(1, w, term.power, {});
      for (std::size_t d = 0; d < 3; ++d) sum[d] += factor * term.c[d];
    }
    return sum;
  }
  Map times(const Matrix3<N>& m) const {
    Map result = *this;
    for (Term& term : result.terms_) term.c = {dot(m[0], term.c), dot(m[1], term.c), dot(m[2], term.c)};
    return result;
  }
  /// Component d at the point.
  const N& value(std::size_t d) const { return terms_[0].c[d]; }
  /// The range of dF_d/dw_j over |dw_i| <= h_i.
  Ball<N> first(std::size_t d, std::size_t j, const Vector4<N>& h) const {
    Power a = {};
    a[j] = 1;
    return derivative(d, a, h);
  }
  /// The range of the second derivative of F_d along vectors in the box t, over |dw_i| <= h_i.
  Ball<N> second(std::size_t d, const Box<N>& t, const Vector4<N>& h) const {
    Ball<N> sum;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i; j < 4; ++j) {
        Power a = {};
        ++a[i];
        ++a[j];
        if (!has(a)) continue;
        const Ball<N> entry = derivative(d, a, h) * t[i] * t[j];
        sum = sum + (i == j ? entry : entry + entry);
      }
    }
    return sum;
  }
  /// The range of the derivative, a_i times to w_i, over |dw_i| <= h_i.
  Ball<N> derivative(std::size_t d, const Power& a, const Vector4<N>& h) const {
    Ball<N> result;
    for (const Term& term : terms_) {
      int factor = 1;
      for (std::size_t j = 0; j < 4; ++j)
        for (int i = 0; i < a[j]; ++i) factor *= term.power[j] - i;
      if (factor == 0) continue;
      if (term.power == a)
        result.middle = factor * term.c[d];
      else
        result.radius += magnitude(term.c[d]) * product(factor, h, term.power, a);
    }
    return result;
  }

 private:
  bool has(const Power& power) const {
    for (const Term& term : terms_)
      if (term.power == power) return true;
    return false;
  }
  /// factor w^(power - lower)
  static N product(int factor, const Vector4<N>& w, const Power& power, const Power& lower) {
    N result = factor;
    for (std::size_t j = 0; j < 4; ++j)
      for (int i = lower[j]; i < power[j]; ++i) result = result * w[j];
    return result;
  }
  std::vector<Term> terms_;
};

/// x(u,v), or with factor -1 and by 2 variables later -y(r,s), added to the map.
template <class N>
void add_patch(Map<N>& map, const Net<N>& c, const N& factor, std::size_t later) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      Power power = {};
      power[later] = static_cast<int>(i);
      power[later + 1] = static_cast<int>(j);
      map.add(power, c[i][j], factor);
    }
  }
}
/// F = x(u,v) - y(r,s).
template <class N>
Map<N> pair_map(const Net<N>& x, const Net<N>& y) {
  Map<N> map;
  add_patch(map, x, N(1), 0);
  add_patch(map, y, N(-1), 2);
  return map;
}

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

/// T over |dw_i| <= h_i: T_k is (-1)^k times the determinant of the columns of DF other than k, and T_i / T_k
/// is the derivative of w_i with respect to w_k along the curve.
template <class N>
Box<N> tangent(const Map<N>& local, const Vector4<N>& h) {
  Box<N> result;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto entry = [&](std::size_t d, std::size_t j) { return local.first(d, others(k)[j], h); };
    const auto minor = [&](std::size_t i, std::size_t j) {
      return entry(1, i) * entry(2, j) - entry(1, j) * entry(2, i);
    };
    const Ball<N> t = entry(0, 0) * minor(1, 2) + entry(0, 1) * minor(2, 0) + entry(0, 2) * minor(0, 1);
    result[k] = k % 2 == 0 ? t : -t;
  }
  return result;
}

/// Which map is F, and in which variables.
enum class Chart {
  pair,    // x(u,v) - y(r,s); of one patch x(u,v) - x(r,s)
  first,   // H of a patch: (U,V,m,w)
  second,  // H of the patch with u and v exchanged
};

/// The set of all centre + t slope + e, |t| <= reach, |e_i| <= width, e_k = 0; slope_k = 1.
template <class N>
struct Tube {
  Vector4<N> centre;
  std::size_t axis;
  Vector4<N> slope;
  N reach;
  N width;
  Matrix3<N> inverse;
  Chart chart = Chart::pair;
  int line = -1;  // the exact solution that the curve is; -1 if none is claimed

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
  std::array<Vector3<N>, 9> p = {};  // C F(centre + t slope) = p_0 + p_1 t + ...
  for (const auto& term : local.terms()) {
    N factor = 1;
    int degree = 0;
    for (std::size_t j = 0; j < 4; ++j, degree += term.power[j - 1])
      for (int i = 0; i < term.power[j]; ++i) factor = factor * tube.slope[j];
    for (std::size_t d = 0; d < 3; ++d) p[static_cast<std::size_t>(degree)][d] += factor * term.c[d];
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
