// The charts of a star: t and d for the parameters, and F in them.
#pragma once

#include <cmath>
#include <map>

#include "certificate.h"

namespace exsect::checker {

/// The coordinates of a star in the numbers of the check.
template <class N>
struct Frame {
  Vector4<N> at;
  std::array<Vector4<N>, 4> coordinates;

  Frame() = default;
  explicit Frame(const Star& star) {
    for (std::size_t j = 0; j < 4; ++j) {
      at[j] = number<N>(star.at[j]);
      for (std::size_t i = 0; i < 4; ++i) coordinates[j][i] = number<N>(star.coordinates[j][i]);
    }
  }
  /// e, w = at + sum_j axes_j e_j, of a box of parameters, or of a place.
  template <class B>
  std::array<B, 4> of(const std::array<B, 4>& w) const {
    std::array<B, 4> e;
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i)
        if (coordinates[j][i] != 0) e[j] = e[j] + B(coordinates[j][i]) * (w[i] - B(at[i]));
    return e;
  }
};

/// t > 0 with t^n = a, for a > 0: with q near it, |t - q| <= |t^n - q^n| / q^(n-1).
template <class N>
Ball<N> root(const Ball<N>& a, std::size_t n) {
  if (n == 1) return a;
  const double near = std::pow(approximate(a.middle), 1.0 / static_cast<double>(n));
  require(near > 0 && std::isfinite(near), "no root");
  const N q = N(near);
  N power = 1;  // q^(n-1)
  for (std::size_t i = 1; i < n; ++i) power = power * q;
  return {q, (magnitude(N(power * q - a.middle)) + a.radius) / power};
}

/// The box of parameters as t (variable k) and d in the chart: coordinates (w - at) = d t^weights, d_k = 1 or
/// -1.
template <class N>
Box<N> in_star(const Star& star, const Frame<N>& frame, std::size_t direction, const Box<N>& w) {
  Box<N> e = frame.of(w);
  const std::size_t k = direction / 2;
  const Ball<N> size = direction % 2 == 0 ? e[k] : -e[k];
  require(size.sign() > 0, "not on its side of the star's point");
  const Ball<N> t = root(size, star.weights[k]);
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t n = 0; j != k && n < star.weights[j]; ++n) e[j] = e[j] / t;
  e[k] = t;
  return e;
}
/// The parameters of all (t, d) in the box.
template <class N>
Box<N> from_star(const Star& star, std::size_t direction, Box<N> z) {
  const std::size_t k = direction / 2;
  const Ball<N> t = z[k];
  z[k] = N(direction % 2 == 0 ? 1 : -1);
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t n = 0; n < star.weights[j]; ++n) z[j] = z[j] * t;
  Box<N> w;
  for (std::size_t i = 0; i < 4; ++i) {
    w[i] = number<N>(star.at[i]);
    for (std::size_t j = 0; j < 4; ++j)
      if (star.axes[i][j] != 0) w[i] = w[i] + number<N>(star.axes[i][j]) * z[j];
  }
  return w;
}

/// A polynomial in e = coordinates (w - at).
using Terms = std::map<Power, Vector3<Algebraic>>;
inline Terms centred(const Map<Rational>& map, const Star& star) {
  Terms result;
  const Map<Algebraic> local = rounded<Algebraic>(map).at(star.at);
  for (const auto& term : local.terms()) {
    std::map<Power, Algebraic> product = {{Power{}, 1}};  // (w - at)^power
    for (std::size_t i = 0; i < 4; ++i) {
      for (int n = 0; n < term.power[i]; ++n) {
        std::map<Power, Algebraic> next;
        for (const auto& [power, c] : product) {
          for (std::size_t j = 0; j < 4; ++j) {
            if (star.axes[i][j] == 0) continue;
            Power more = power;
            ++more[j];
            next[more] += c * star.axes[i][j];
          }
        }
        product = std::move(next);
      }
    }
    for (const auto& [power, c] : product)
      for (std::size_t d = 0; d < 3; ++d) result[power][d] += c * term.c[d];
  }
  return result;
}

inline int weighted_degree(const Star& star, const Power& power) {
  int degree = 0;
  for (std::size_t j = 0; j < 4; ++j) degree += static_cast<int>(star.weights[j]) * power[j];
  return degree;
}

/// `rows` times the polynomial at e = d t^weights, divided by t^orders.
template <class N>
Map<N> in_direction(const Terms& terms, const Star& star, std::size_t direction,
                    const Matrix3<Algebraic>& rows, const std::array<int, 3>& orders) {
  Map<N> map;
  const std::size_t k = direction / 2;
  for (const auto& [power, c] : terms) {
    const int degree = weighted_degree(star, power);
    const int sign = direction % 2 == 1 && power[k] % 2 == 1 ? -1 : 1;
    for (std::size_t d = 0; d < 3; ++d) {
      const Algebraic value = Algebraic(sign) * dot(rows[d], c);
      if (value == 0) continue;
      require(degree >= orders[d], "not of this order at its point");
      Power shifted = power;
      shifted[k] = degree - orders[d];
      map.coefficient(shifted)[d] += number<N>(value);
    }
  }
  map.coefficient(Power{});
  return map;
}

/// For each parameter the sign of its derivative along the half branch in the tube for t > 0, or 0: with w_i
/// - at_i = sum_j axes_ij t^weights_j d_j, the derivative divided by a power of t.
template <class N>
std::array<int, 4> half_branch_signs(const Star& star, const Tube<N>& tube, const CurveBounds<N>& bounds) {
  const Ball<N> t = {tube.reach / 2, tube.reach / 2};
  const Vector4<N> extent = tube.extent();
  const std::size_t k = tube.direction / 2;
  std::array<int, 4> result{};
  for (std::size_t i = 0; i < 4; ++i) {
    std::size_t least = 6;
    for (std::size_t j = 0; j < 4; ++j)
      if (star.axes[i][j] != 0) least = std::min(least, star.weights[j]);
    Ball<N> slope;
    for (std::size_t j = 0; j < 4; ++j) {
      if (star.axes[i][j] == 0) continue;
      const N weight = N(static_cast<int>(star.weights[j]));
      Ball<N> term = tube.direction % 2 == 0 ? weight : N(-weight);
      if (j != k) term = weight * Ball<N>(tube.centre[j], extent[j]) + t * bounds.first[j];
      for (std::size_t n = least; n < star.weights[j]; ++n) term = term * t;
      slope = slope + number<N>(star.axes[i][j]) * term;
    }
    result[i] = slope.sign();
  }
  return result;
}

}  // namespace exsect::checker
