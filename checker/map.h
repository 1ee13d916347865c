// Polynomial maps of four variables to space by their Taylor coefficients, with ranges over boxes, and those
// that certificates speak of (docs/certificate.md). Over Q, and in Enclosure, ranges are proved; over doubles
// they let a writer look for claims.
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

/// A polynomial map, by its Taylor coefficients at a point.
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
          for (int i = 0; i < lower.power[j]; ++i) binomial = binomial * (term.power[j] - i) / (i + 1);
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
  /// The range of n . F over |dw_i| <= h_i.
  Ball<N> along(const Vector3<N>& n, const Vector4<N>& h) const {
    Ball<N> result;
    for (const Term& term : terms_) {
      const N c = dot(n, term.c);
      if (term.power == Power{})
        result.middle = c;
      else
        result.radius += magnitude(c) * product(1, h, term.power, {});
    }
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

}  // namespace exsect::checker
