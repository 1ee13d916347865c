// Factors of F, and their maps in charts of stars.
#pragma once

#include <algorithm>

#include "polynomials.h"
#include "star_maps.h"

namespace exsect::checker {

/// F = sum_j columns_j g_j^powers_j, as polynomials.
inline void check_factor(const Map<Rational>& exact, const Factor& factor) {
  for (const std::size_t power : factor.powers)
    require(power >= 1 && power <= max_factor_power, "a power is not in 1, ..., 6");
  for (std::size_t d = 0; d < 3; ++d) {
    Polynomial rest = component(exact, d);
    for (std::size_t j = 0; j < 3; ++j) {
      const Polynomial g = component(factor.map, j);
      Polynomial term = component(factor.columns[j], d);
      require(degree(term) + static_cast<int>(factor.powers[j]) * degree(g) <= 2 * max_factor_degree,
              "a product of a degree above 24");
      for (std::size_t n = 0; n < factor.powers[j]; ++n) term = product(term, g);
      add(rest, term, -1);
    }
    require(is_zero(rest), "not a sum of multiples of its map");
  }
}

/// The columns are independent in the box; of a surface the first two.
template <class N>
bool independent(const std::array<Map<N>, 3>& columns, const Box<N>& box) {
  std::array<Balls<N>, 3> c;
  for (std::size_t j = 0; j < 3; ++j) c[j] = Ranges(columns[j].at(middles(box)), radii(box)).value();
  const Balls<N> normal = cross(c[0], c[1]);
  for (std::size_t d = 0; columns[2].terms().empty() && d < 3; ++d)
    c[2][d] = N(approximate(normal[d].middle));  // any vector will do
  return dot(normal, c[2]).sign() != 0;
}

/// Component d of the map vanishes wherever these parameters have these values.
inline bool vanishes(const Map<Rational>& map, std::size_t d, const std::vector<Side>& known) {
  Vector4<Rational> w = {};
  for (const Side& side : known) w[side.parameter] = side.value;
  const Map<Rational> local = map.at(w);
  return std::all_of(local.terms().begin(), local.terms().end(), [&](const auto& term) {
    return term.c[d] == 0 || std::any_of(known.begin(), known.end(),
                                         [&](const Side& side) { return term.power[side.parameter] > 0; });
  });
}

/// Of the surface nothing but the map's curve is in [0,1]^4: g_1 is linear in two parameters, and there 0 at
/// one corner alone, where g_3 is.
inline bool is_edge(const Map<Rational>& map) {
  const auto at = [&](std::size_t i, int a, std::size_t j, int b) {
    Vector4<Rational> w = {};
    w[i] = a;
    w[j] = b;
    return sign(map.value(w)[0]);
  };
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const bool linear = std::all_of(map.terms().begin(), map.terms().end(), [&](const auto& term) {
        const Power& p = term.power;
        return term.c[0] == 0 || (p[0] + p[1] + p[2] + p[3] <= 1 && p[i] + p[j] == p[0] + p[1] + p[2] + p[3]);
      });
      for (int corner = 0; linear && corner < 4; ++corner) {
        const int a = corner / 2;
        const int b = corner % 2;
        const std::vector<Side> sides = {{{i}, a}, {{j}, b}};
        if (at(i, a, j, b) == 0 && at(i, 1 - a, j, b) * at(i, a, j, 1 - b) > 0 && vanishes(map, 2, sides))
          return true;
      }
    }
  }
  return false;
}

/// Parameters that are constant where the map vanishes, in the box: the only ones in a component that are not
/// known to be constant, and it is monotone in them. `near`: the map in numbers of the check.
template <class N>
std::array<bool, 4> constant_in(const Map<Rational>& map, const Map<N>& near, const Box<N>& box) {
  std::array<bool, 4> result = {};
  const Map<N> local = near.at(middles(box));
  const Ranges over(local, radii(box));
  for (std::size_t n = 0; n < 64; ++n) {
    const std::size_t i = n % 4;
    const std::size_t d = n / 4 % 3;
    if (result[i]) continue;
    const bool alone = std::all_of(map.terms().begin(), map.terms().end(), [&](const auto& term) {
      bool other = false;
      for (const std::size_t j : others(i)) other = other || (term.power[j] > 0 && !result[j]);
      return !other || term.c[d] == 0;
    });
    if (alone && over.first(i)[d].sign() != 0) result[i] = true;
  }
  return result;
}

/// The map and the columns of a factor; in a chart divided by powers of t, as `rows` F is.
template <class N>
struct FactorMaps {
  Map<N> map;
  std::array<Map<N>, 3> columns;
};
template <class N>
FactorMaps<N> factor_maps(const Factor& factor) {
  const auto& [a, b, c] = factor.columns;
  return {rounded<N>(factor.map), {rounded<N>(a), rounded<N>(b), rounded<N>(c)}};
}
template <class N>
FactorMaps<N> factor_in_direction(const Factor& factor, const Star& star, std::size_t direction) {
  const Terms terms = centred(factor.map, star);
  std::array<int, 3> orders = {1000, 1000, 1000};
  for (const auto& [power, c] : terms)
    for (std::size_t d = 0; d < 3; ++d)
      if (c[d] != 0) orders[d] = std::min(orders[d], weighted_degree(star, power));
  for (const int order : orders) require(order < 1000, "a component of its map is 0");
  FactorMaps<N> result = {
      in_direction<N>(terms, star, direction, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, orders), {}};
  for (std::size_t j = 0; j < 3; ++j) {
    std::array<int, 3> rest = star.orders;
    for (int& order : rest) order -= static_cast<int>(factor.powers[j]) * orders[j];
    result.columns[j] = in_direction<N>(centred(factor.columns[j], star), star, direction, star.rows, rest);
  }
  return result;
}

}  // namespace exsect::checker
