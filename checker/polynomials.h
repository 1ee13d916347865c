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
/// The polynomial of two parameters, `first` and the next one, with these coefficients.
inline Polynomial polynomial_in(const Grid<Rational, 1>& coefficients, std::size_t first) {
  Polynomial result;
  coefficients.each([&](std::size_t i, std::size_t j) {
    Power power = {};
    power[first] = static_cast<int>(i);
    power[first + 1] = static_cast<int>(j);
    result[power] = coefficients[i][j][0];
  });
  return result;
}
/// The derivative with respect to w_j.
inline Polynomial derivative(const Polynomial& a, std::size_t j) {
  Polynomial result;
  for (const auto& [power, c] : a) {
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

inline Polynomial determinant(const std::array<Vector3<Polynomial>, 3>& columns) {
  const auto& [a, b, c] = columns;
  Polynomial sum;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t e = (d + 1) % 3;
    const std::size_t f = (d + 2) % 3;
    add(sum, product(a[d], product(b[e], c[f])), 1);
    add(sum, product(a[d], product(b[f], c[e])), -1);
  }
  return sum;
}

/// a = g h, with no parameters but w_i and w_j in g and only the two others in h: the coefficients, with a
/// row for each pair of exponents in g and a column for each one in h, are a matrix of rank 1. True of a = 0.
inline bool separates(const Polynomial& a, std::size_t i, std::size_t j) {
  const auto part = [&](Power power, bool of_g) {
    for (std::size_t k = 0; k < 4; ++k)
      if ((k == i || k == j) != of_g) power[k] = 0;
    return power;
  };
  const auto entry = std::find_if(a.begin(), a.end(), [](const auto& term) { return term.second != 0; });
  if (entry == a.end()) return true;
  Polynomial g;  // the column of the entry
  Polynomial h;  // its row
  for (const auto& [power, c] : a) {
    if (part(power, false) == part(entry->first, false)) g[part(power, true)] = c;
    if (part(power, true) == part(entry->first, true)) h[part(power, false)] = c;
  }
  Polynomial difference = product(g, h);
  for (const auto& [power, c] : a) difference[power] -= entry->second * c;
  return is_zero(difference);
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

/// T_i vanishes wherever the parameters are on the sides and the map is 0: with the columns c F_j - c_j F,
/// parallel to F_j there, of a factor c > 0 for w_j's patch, it is as a polynomial in the others a multiple
/// of a component of the map, of 0 at least.
inline bool turns_on_sides(const Map<Rational>& map, const std::array<Polynomial, 2>& factors, std::size_t i,
                           const std::vector<Side>& sides) {
  std::array<Vector3<Polynomial>, 3> column;
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t j = others(i)[n];
    const Polynomial& c = factors[j / 2];
    for (std::size_t d = 0; d < 3; ++d) {
      const Polynomial f = component(map, d);
      Polynomial& entry = column[n][d] = product(on_sides(c, sides), on_sides(derivative(f, j), sides));
      add(entry, product(on_sides(derivative(c, j), sides), on_sides(f, sides)), -1);
    }
  }
  const Polynomial sum = determinant(column);
  bool result = is_zero(sum);
  for (std::size_t d = 0; d < 3 && !result; ++d) {
    const Polynomial g = on_sides(component(map, d), sides);
    result = !is_zero(g) && is_multiple(sum, g);
  }
  return result;
}

}  // namespace exsect::checker
