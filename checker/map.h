// Polynomial maps of four variables to space by their Taylor coefficients, with ranges over boxes, and those
// that certificates speak of (docs/certificate.md). Over Q, and in Enclosure, ranges are proved; over doubles
// they let a writer look for claims.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
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
/// -1, 0, 1.
template <class N>
int sign_of(const N& a) {
  return a > 0 ? 1 : a < 0 ? -1 : 0;
}
/// sum + a b
template <class N>
void add_multiple(N& sum, const N& a, const N& b) {
  sum = sum + a * b;
}
template <class N>
N dot(const Vector3<N>& a, const Vector3<N>& b) {
  N sum = a[0] * b[0];
  add_multiple(sum, a[1], b[1]);
  add_multiple(sum, a[2], b[2]);
  return sum;
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
    std::array<int, 4> lower;  // the terms with one exponent less by 1, -1 where it is 0
  };
  const std::vector<Term>& terms() const { return terms_; }

  /// The coefficient of a monomial; with each monomial there are all that divide it before it, 1 the first.
  Vector3<N>& coefficient(const Power& power) { return terms_[static_cast<std::size_t>(index(power))].c; }
  void add(const Power& power, const Vector3<N>& c, const N& factor) {
    add_to(coefficient(power), c, factor);
  }

  /// Adds factor times a map of the same monomials in the same order.
  void add(const Map& other, const N& factor) {
    for (std::size_t i = 0; i < terms_.size(); ++i) add_to(terms_[i].c, other.terms_[i].c, factor);
  }

  /// The Taylor coefficients at another point, w further, by Horner's rule.
  Map at(const Vector4<N>& w) const {
    Map result = *this;
    for (std::size_t j = 0; j < 4; ++j)
      if (!(w[j] == N(0))) result.shift(j, w[j]);
    return result;
  }
  Vector3<N> value(const Vector4<N>& w) const {
    Vector3<N> sum = {};
    const std::vector<N> monomials = monomials_at(w);
    for (std::size_t i = 0; i < terms_.size(); ++i) add_to(sum, terms_[i].c, monomials[i]);
    return sum;
  }
  Map times(const Matrix3<N>& m) const {
    Map result = *this;
    for (Term& term : result.terms_) term.c = {dot(m[0], term.c), dot(m[1], term.c), dot(m[2], term.c)};
    return result;
  }
  /// Component d at the point.
  const N& value(std::size_t d) const { return terms_[0].c[d]; }
  /// dF/dw_j at the point.
  Vector3<N> slope(std::size_t j) const {
    for (const Term& term : terms_)
      if (term.lower[j] == 0) return term.c;
    return {};
  }
  /// The values of all monomials at w, one product each.
  std::vector<N> monomials_at(const Vector4<N>& w) const {
    std::vector<N> result;
    result.reserve(terms_.size());
    for (const Term& term : terms_) {
      std::size_t j = 0;
      while (j < 4 && term.lower[j] < 0) ++j;
      const int lower = j < 4 ? term.lower[j] : -1;
      result.push_back(lower < 0    ? N(1)
                       : lower == 0 ? w[j]
                                    : N(result[static_cast<std::size_t>(lower)] * w[j]));
    }
    return result;
  }

 private:
  int index(const Power& power) {
    for (std::size_t i = 0; i < terms_.size(); ++i)
      if (terms_[i].power == power) return static_cast<int>(i);
    Term term = {power, {}, {-1, -1, -1, -1}};
    for (std::size_t j = 0; j < 4; ++j) {
      Power lower = power;
      if (--lower[j] >= 0) term.lower[j] = index(lower);
    }
    terms_.push_back(std::move(term));
    return static_cast<int>(terms_.size()) - 1;
  }
  /// w_j further: Horner's rule in each line of terms that differ in its exponent alone. Greater exponents
  /// come after lesser ones.
  void shift(std::size_t j, const N& w) {
    bool more = true;
    for (int k = 0; more; ++k) {
      more = false;
      for (std::size_t i = terms_.size(); i-- > 1;) {
        if (terms_[i].power[j] <= k) continue;
        add_to(terms_[static_cast<std::size_t>(terms_[i].lower[j])].c, terms_[i].c, w);
        more = true;
      }
    }
  }
  static void add_to(Vector3<N>& sum, const Vector3<N>& c, const N& factor) {
    for (std::size_t d = 0; d < 3; ++d) add_multiple(sum[d], factor, c[d]);
  }

  std::vector<Term> terms_;
};

/// The ranges of a map and its derivatives over the box |dw_i| <= h_i. The map outlives it.
template <class N>
class Ranges {
 public:
  Ranges(const Map<N>& map, const Vector4<N>& h) : terms_(map.terms()), size_(map.monomials_at(h)) {}

  Balls<N> value() const {
    return sum_over([](std::size_t i) { return Part{static_cast<int>(i), 1}; });
  }
  /// Of dF/dw_j.
  Balls<N> first(std::size_t j) const {
    return sum_over([&](std::size_t i) { return Part{terms_[i].lower[j], terms_[i].power[j]}; });
  }
  /// Of the second derivative along vectors in the box t.
  Balls<N> second(const Box<N>& t) const {
    std::array<std::array<std::optional<Balls<N>>, 4>, 4> entries;
    for (const Term& term : terms_) {
      for (std::size_t j = 0; j < 4; ++j) {
        if (term.lower[j] < 0) continue;
        const Term& lower = terms_[static_cast<std::size_t>(term.lower[j])];
        for (std::size_t k = j; k < 4; ++k) {
          if (lower.lower[k] < 0) continue;
          if (!entries[j][k]) entries[j][k].emplace();
          add(*entries[j][k], term.c, {lower.lower[k], term.power[j] * lower.power[k]});
        }
      }
    }
    Balls<N> sum;
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = j; k < 4; ++k) {
        if (!entries[j][k]) continue;
        const Ball<N> square = t[j] * t[k];
        const Ball<N> factor = j == k ? square : square + square;
        for (std::size_t d = 0; d < 3; ++d) sum[d] = sum[d] + (*entries[j][k])[d] * factor;
      }
    }
    return sum;
  }

 private:
  using Term = typename Map<N>::Term;
  /// The derivative of a monomial: factor times that of another term; 0 where this is -1.
  struct Part {
    int term;
    int factor;
  };

  /// The sum of the terms with their monomials' derivatives; that of a constant is no radius.
  template <class PartOf>
  Balls<N> sum_over(const PartOf& part_of) const {
    Balls<N> result;
    for (std::size_t i = 0; i < terms_.size(); ++i)
      if (const Part part = part_of(i); part.term >= 0) add(result, terms_[i].c, part);
    return result;
  }
  void add(Balls<N>& sum, const Vector3<N>& c, const Part& part) const {
    N size = size_[static_cast<std::size_t>(part.term)];
    if (part.factor != 1) size = N(part.factor) * size;
    for (std::size_t d = 0; d < 3; ++d) {
      if (part.term == 0)
        sum[d].middle = size * c[d];
      else
        add_multiple(sum[d].radius, size, checker::magnitude(c[d]));
    }
  }

  const std::vector<Term>& terms_;
  std::vector<N> size_;  // of all monomials
};

template <class N>
Map<N> rounded(const Map<Rational>& map) {
  Map<N> result;
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
  add_product(map, x.points, y.weights, N(1), 0);
  add_product(map, y.points, x.weights, N(-1), 2);
  return map;
}

/// The range of n . F over |dw_i| <= h_i.
template <class N>
Ball<N> along(const Vector3<N>& n, const Map<N>& map, const Vector4<N>& h) {
  return Ranges(map.times({n, {}, {}}), h).value()[0];
}

/// T over |dw_i| <= h_i: T_k is (-1)^k times the determinant of the columns of DF other than k, and T_i / T_k
/// is the derivative of w_i with respect to w_k along the curve.
template <class N>
Box<N> tangent(const Map<N>& local, const Vector4<N>& h) {
  const Ranges over(local, h);
  const std::array<Balls<N>, 4> column = {over.first(0), over.first(1), over.first(2), over.first(3)};
  Box<N> result;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [a, b, c] = others(k);
    const Ball<N> t = dot(column[a], cross(column[b], column[c]));
    result[k] = k % 2 == 0 ? t : -t;
  }
  return result;
}

}  // namespace exsect::checker
