// Polynomials in u, v, r, s over Q, by their coefficients. Internal to checker/.
#pragma once

#include <map>

#include "certificate.h"

namespace exsect::checker {

/// Coefficients may be 0.
using Polynomial = std::map<Power, Rational>;

inline Polynomial component(const Map<Rational>& map, std::size_t d) {
  Polynomial result;
  for (const auto& term : map.terms())
    if (term.c[d] != 0) result[term.power] = term.c[d];
  return result;
}
/// The greatest sum of exponents; 0 for 0.
inline int degree(const Polynomial& a) {
  int result = 0;
  for (const auto& [power, c] : a)
    if (c != 0) result = std::max(result, power[0] + power[1] + power[2] + power[3]);
  return result;
}
inline bool is_zero(const Polynomial& a) {
  return std::all_of(a.begin(), a.end(), [](const auto& term) { return term.second == 0; });
}
/// Adds factor b to a.
inline void add(Polynomial& a, const Polynomial& b, int factor) {
  for (const auto& [power, c] : b) a[power] += factor * c;
}
inline Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [p, c] : a) {
    for (const auto& [q, d] : b) {
      const Power sum = {p[0] + q[0], p[1] + q[1], p[2] + q[2], p[3] + q[3]};
      result[sum] += c * d;
    }
  }
  return result;
}
/// The derivative of component d of the map with respect to w_j.
inline Polynomial derivative(const Map<Rational>& map, std::size_t d, std::size_t j) {
  Polynomial result;
  for (const auto& [power, c] : component(map, d)) {
    if (power[j] == 0) continue;
    Power lower = power;
    --lower[j];
    result[lower] = power[j] * c;
  }
  return result;
}
/// With these values, 0 or 1, for these parameters.
inline Polynomial on_sides(const Polynomial& a, const std::vector<Side>& sides) {
  Polynomial result;
  for (const auto& [power, c] : a) {
    Power rest = power;
    bool vanishes = false;
    for (const Side& side : sides) {
      vanishes = vanishes || (side.value == 0 && power[side.parameter] > 0);
      rest[side.parameter] = 0;
    }
    if (!vanishes) result[rest] += c;
  }
  return result;
}

/// b, which is not 0, divides a: by division with the lexicographically greatest terms first.
inline bool is_multiple(Polynomial a, const Polynomial& b) {
  const auto leading = [](const Polynomial& p) {
    return std::find_if(p.rbegin(), p.rend(), [](const auto& term) { return term.second != 0; });
  };
  const auto divisor = leading(b);
  for (auto first = leading(a); first != a.rend(); first = leading(a)) {
    Power power = first->first;
    for (std::size_t j = 0; j < 4; ++j) power[j] -= divisor->first[j];
    if (*std::min_element(power.begin(), power.end()) < 0) return false;
    const Rational quotient = first->second / divisor->second;
    a.erase(std::next(first).base(), a.end());
    for (auto term = std::next(divisor); term != b.rend(); ++term) {
      Power shifted = power;
      for (std::size_t j = 0; j < 4; ++j) shifted[j] += term->first[j];
      a[shifted] -= quotient * term->second;
    }
  }
  return true;
}

}  // namespace exsect::checker
