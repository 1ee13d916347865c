// Polynomial maps of four variables to space by their Taylor coefficients, with ranges over boxes, and those
// that certificates speak of (docs/certificate.md). Over Q, and in Enclosure, ranges are proved; over doubles
// they let a writer look for claims.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "net.h"
#include "require.h"

namespace exsect::checker {

template <class N>
using Vector4 = std::array<N, 4>;
template <class N>
using Vector3 = std::array<N, 3>;
template <class N>
using Matrix3 = std::array<std::array<N, 3>, 3>;

template <class N>
N magnitude(const N& a) {
  return a < 0 ? N(-a) : a;
}
template <class N>
const N& larger(const N& a, const N& b) {
  return a < b ? b : a;
}
template <class N>
const N& smaller(const N& a, const N& b) {
  return b < a ? b : a;
}
/// The integer n.
template <class N>
N whole(std::int64_t n) {
  if constexpr (std::is_same_v<N, Enclosure>)
    return Enclosure::whole(n);
  else if constexpr (std::is_same_v<N, double>)
    return static_cast<double>(n);
  else
    return N(Rational(n));
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
template <class N>
Vector3<N> cross(const Vector3<N>& a, const Vector3<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// All numbers within `radius` of `middle`.
template <class N>
struct Ball {
  N middle{};
  N radius{};

  Ball() = default;
  Ball(N m, N r = N(0)) : middle(std::move(m)), radius(std::move(r)) {}

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
  /// |a/b - q| = |a - q b| / |b|, q the quotient of the middles; fails where b may be 0.
  friend Ball operator/(const Ball& a, const Ball& b) {
    require(b.sign() != 0, "a divisor that may be 0");
    const N q = a.middle / b.middle;
    return {q, (a.radius + checker::magnitude(q) * b.radius) / b.least()};
  }
};
template <class N>
using Box = std::array<Ball<N>, 4>;
template <class N>
using Balls = std::array<Ball<N>, 3>;

/// All places within `radius` of `at` in each variable.
template <class N>
Box<N> box_around(const Vector4<N>& at, const N& radius) {
  return {Ball<N>(at[0], radius), {at[1], radius}, {at[2], radius}, {at[3], radius}};
}
template <class N>
Vector4<N> middles(const Box<N>& box) {
  return {box[0].middle, box[1].middle, box[2].middle, box[3].middle};
}
/// Half its edges.
template <class N>
Vector4<N> radii(const Box<N>& box) {
  return {box[0].radius, box[1].radius, box[2].radius, box[3].radius};
}

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
  /// Whether it is treated as a map of many terms: F of patches with weights has up to 256, of others 31; H
  /// of a chart up to some 900.
  bool is_long() const { return is_long_; }
  void set_long(bool value) {
    is_long_ = value;
    next_.clear();
    for (std::size_t i = 0; is_long_ && i < terms_.size(); ++i) link(i);
  }

  /// The coefficient of a monomial; with each monomial there are all that divide it, 1 the first.
  Vector3<N>& coefficient(const Power& power) { return terms_[index(power)].c; }
  void add(const Power& power, const Vector3<N>& c, const N& factor) {
    add_to(coefficient(power), c, factor);
  }

  /// Adds factor times a map of the same monomials in the same order.
  void add_multiple(const Map& other, const N& factor) {
    for (std::size_t i = 0; i < terms_.size(); ++i) add_to(terms_[i].c, other.terms_[i].c, factor);
  }

  /// The Taylor coefficients at another point, w further: term by term, or of a long map by Horner's rule.
  Map at(const Vector4<N>& w) const {
    Map result = *this;
    if (is_long_) {
      for (std::size_t j = 0; j < 4; ++j) result.shift(j, w[j]);
      return result;
    }
    for (Term& lower : result.terms_) {
      for (const Term& term : terms_) {
        if (!divides(lower.power, term.power) || term.power == lower.power) continue;
        std::int64_t binomial = 1;
        for (std::size_t j = 0; j < 4; ++j)
          for (int i = 0; i < lower.power[j]; ++i)
            binomial = multiplied(binomial, term.power[j] - i) / (i + 1);
        add_to(lower.c, term.c, product(binomial, w, term.power, lower.power));
      }
    }
    return result;
  }
  Vector3<N> value(const Vector4<N>& w) const {
    Vector3<N> sum = {};
    const Powers powers = powers_of(w);
    for (const Term& term : terms_)
      add_to(sum, term.c, is_long_ ? product(1, powers, term.power, {}) : product(1, w, term.power, {}));
    return sum;
  }
  Map times(const Matrix3<N>& m) const {
    Map result = *this;
    for (Term& term : result.terms_) term.c = {dot(m[0], term.c), dot(m[1], term.c), dot(m[2], term.c)};
    return result;
  }
  /// Component d at the point.
  const N& value(std::size_t d) const { return terms_[0].c[d]; }

  /// The range of the derivative, a_i times to w_i, over |dw_i| <= h_i.
  Balls<N> derivative(const Power& a, const Vector4<N>& h) const {
    Balls<N> result;
    const Powers powers = powers_of(h);
    for (const Term& term : terms_) {
      if (!divides(a, term.power)) continue;
      std::int64_t factor = 1;
      for (std::size_t j = 0; j < 4; ++j)
        for (int i = 0; i < a[j]; ++i) factor = multiplied(factor, term.power[j] - i);
      const N size = is_long_ ? product(factor, powers, term.power, a) : product(factor, h, term.power, a);
      for (std::size_t d = 0; d < 3; ++d)
        term.power == a ? result[d].middle = size * term.c[d]
                        : result[d].radius += size * magnitude(term.c[d]);
    }
    return result;
  }
  /// That of dF/dw_j.
  Balls<N> first(std::size_t j, const Vector4<N>& h) const {
    Power a = {};
    a[j] = 1;
    return derivative(a, h);
  }
  /// That of the second derivative along vectors in the box t.
  Balls<N> second(const Box<N>& t, const Vector4<N>& h) const {
    Balls<N> sum;
    for (const Term& term : terms_) {
      if (term.power[0] + term.power[1] + term.power[2] + term.power[3] != 2) continue;
      Ball<N> factor = N(1);
      for (std::size_t j = 0; j < 4; ++j)
        for (int i = 0; i < term.power[j]; ++i) factor = factor * t[j];
      const bool square = *std::max_element(term.power.begin(), term.power.end()) == 2;
      const Balls<N> entry = derivative(term.power, h);
      for (std::size_t d = 0; d < 3; ++d) sum[d] = sum[d] + N(square ? 1 : 2) * entry[d] * factor;
    }
    return sum;
  }

 private:
  std::size_t index(const Power& power) {
    for (std::size_t i = 0; i < terms_.size(); ++i)
      if (terms_[i].power == power) return i;
    for (std::size_t j = 0; j < 4; ++j) {
      Power lower = power;
      if (--lower[j] >= 0) index(lower);
    }
    terms_.push_back({power, {}});
    if (is_long_) link(terms_.size() - 1);
    return terms_.size() - 1;
  }
  /// The term follows those before it.
  void link(std::size_t i) {
    next_.push_back({});
    for (std::size_t j = 0; j < 4; ++j) {
      Power lower = terms_[i].power;
      if (--lower[j] >= 0) next_[index(lower)][j] = i;
    }
  }
  /// w_j further, in each line of terms that differ in its exponent alone.
  void shift(std::size_t j, const N& w) {
    std::vector<std::size_t> line;
    for (std::size_t first = 0; first < terms_.size(); ++first) {
      if (terms_[first].power[j] > 0) continue;
      line = {first};
      while (next_[line.back()][j] > 0) line.push_back(next_[line.back()][j]);
      for (std::size_t k = 0; k + 1 < line.size(); ++k)
        for (std::size_t i = line.size() - 1; i-- > k;) add_to(terms_[line[i]].c, terms_[line[i + 1]].c, w);
    }
  }
  static bool divides(const Power& a, const Power& b) {
    return a[0] <= b[0] && a[1] <= b[1] && a[2] <= b[2] && a[3] <= b[3];
  }
  static void add_to(Vector3<N>& sum, const Vector3<N>& c, const N& factor) {
    for (std::size_t d = 0; d < 3; ++d) sum[d] += factor * c[d];
  }
  /// Exactly: the binomial coefficients of four exponents leave 64 bits.
  static std::int64_t multiplied(std::int64_t a, int b) {
    std::int64_t result = 0;
    require(!__builtin_mul_overflow(a, b, &result), "the exponents of a map are too large");
    return result;
  }
  /// factor w^(power - lower)
  static N product(std::int64_t factor, const Vector4<N>& w, const Power& power, const Power& lower) {
    N result = whole<N>(factor);
    for (std::size_t j = 0; j < 4; ++j)
      for (int i = lower[j]; i < power[j]; ++i) result = result * w[j];
    return result;
  }
  /// Of each variable its powers, 1 first.
  using Powers = std::array<std::vector<N>, 4>;
  /// As far as the terms have them; nothing for a map that is not long.
  Powers powers_of(const Vector4<N>& w) const {
    Powers result;
    if (!is_long_) return result;
    for (std::size_t j = 0; j < 4; ++j) {
      int most = 0;
      for (const Term& term : terms_) most = std::max(most, term.power[j]);
      result[j] = {N(1)};
      for (int i = 0; i < most; ++i) result[j].push_back(result[j].back() * w[j]);
    }
    return result;
  }
  static N product(std::int64_t factor, const Powers& powers, const Power& power, const Power& lower) {
    N result = whole<N>(factor);
    for (std::size_t j = 0; j < 4; ++j)
      if (power[j] > lower[j]) result = result * powers[j][static_cast<std::size_t>(power[j] - lower[j])];
    return result;
  }

  std::vector<Term> terms_;
  std::vector<std::array<std::size_t, 4>> next_;  // of a long map: terms with one exponent greater by 1, or 0
  bool is_long_ = false;
};

template <class N>
Map<N> rounded(const Map<Rational>& map) {
  Map<N> result;
  result.set_long(map.is_long());
  for (const auto& term : map.terms())
    result.coefficient(term.power) = {N(term.c[0]), N(term.c[1]), N(term.c[2])};
  return result;
}

/// Adds factor x(u,v) w(r,s) for these coefficients; with first = 2 the same of x(r,s) w(u,v).
template <class N>
void add_product(Map<N>& map, const Net<N>& x, const Grid<N, 1>& w, const N& factor, std::size_t first) {
  x.each([&](std::size_t i, std::size_t j) {
    w.each([&](std::size_t k, std::size_t l) {
      Power power = {};
      power[first] = static_cast<int>(i);
      power[first + 1] = static_cast<int>(j);
      power[2 - first] = static_cast<int>(k);
      power[3 - first] = static_cast<int>(l);
      map.add(power, x[i][j], factor * w[k][l][0]);
    });
  });
}
/// F = w_y X - w_x Y for x = X(u,v)/w_x(u,v) and y = Y(r,s)/w_y(r,s), given by their coefficients.
template <class N>
Map<N> pair_map(const WeightedNet<N>& x, const WeightedNet<N>& y) {
  Map<N> map;
  map.set_long(x.has_weights() || y.has_weights());
  add_product(map, x.points, y.weights, N(1), 0);
  add_product(map, y.points, x.weights, N(-1), 2);
  return map;
}

/// The range of n . F over |dw_i| <= h_i.
template <class N>
Ball<N> along(const Vector3<N>& n, const Map<N>& map, const Vector4<N>& h) {
  return map.times({n, {}, {}}).derivative({}, h)[0];
}

/// T over |dw_i| <= h_i: T_k is (-1)^k times the determinant of the columns of DF other than k, and T_i / T_k
/// is the derivative of w_i with respect to w_k along the curve.
template <class N>
Box<N> tangent(const Map<N>& local, const Vector4<N>& h) {
  const std::array<Balls<N>, 4> column = {local.first(0, h), local.first(1, h), local.first(2, h),
                                          local.first(3, h)};
  Box<N> result;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [a, b, c] = others(k);
    const Ball<N> t = dot(column[a], cross(column[b], column[c]));
    result[k] = k % 2 == 0 ? t : -t;
  }
  return result;
}

}  // namespace exsect::checker
