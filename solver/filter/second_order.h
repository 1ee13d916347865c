// Taylor coefficients of a patch in space, from those of its homogeneous coordinates. Internal to solver/.
#pragma once

#include <exsect/algebra/rational.h>

#include "filter/kind.h"

namespace exsect::filter {

/// Coefficients of 1, h, k, h^2, h k and k^2.
template <class Number>
struct SecondOrderOf {
  std::array<Number, 3> value, u, v, uu, uv, vv;
};
using SecondOrder = SecondOrderOf<double>;
using ExactSecondOrder = SecondOrderOf<Rational>;

/// Of x = X / W, from those of X and W: x W = X order by order. Exact numbers give exact ones; W is not 0.
template <class K, class Number>
SecondOrderOf<Number> in_space(const std::array<std::array<Number, K::rows>, K::count>& c) {
  constexpr std::size_t u = kFirst<K>;
  constexpr std::size_t v = kSecond;
  const auto vector = [&](std::size_t i) { return std::array<Number, 3>{c[i][0], c[i][1], c[i][2]}; };
  SecondOrderOf<Number> x = {vector(0), vector(u), vector(v), vector(2 * u), vector(u + v), vector(2 * v)};
  if constexpr (K::weighted) {
    const auto weight = [&](std::size_t i) -> const Number& { return c[i][3]; };
    const Number inverse = 1 / weight(0);
    for (std::size_t k = 0; k < 3; ++k) {
      x.value[k] /= weight(0);
      x.u[k] = inverse * (x.u[k] - weight(u) * x.value[k]);
      x.v[k] = inverse * (x.v[k] - weight(v) * x.value[k]);
      x.uu[k] = inverse * (x.uu[k] - weight(2 * u) * x.value[k] - weight(u) * x.u[k]);
      x.uv[k] = inverse * (x.uv[k] - weight(u + v) * x.value[k] - weight(v) * x.u[k] - weight(u) * x.v[k]);
      x.vv[k] = inverse * (x.vv[k] - weight(2 * v) * x.value[k] - weight(v) * x.v[k]);
    }
  }
  return x;
}

}  // namespace exsect::filter
