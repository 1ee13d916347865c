// The curve of an equation in the square of a patch: F = (f(x(u,v)), r - 1/2, s - 1/2).
#pragma once

#include "polynomials.h"

namespace exsect::checker {

/// The greatest sum of exponents; 0 for 0.
inline int degree(const SurfaceEquation& f) {
  int result = 0;
  for (const auto& [power, c] : f)
    if (c != 0) result = std::max(result, power[0] + power[1] + power[2]);
  return result;
}

/// X, Y, Z and w of the patch (X, Y, Z) / w, of its coefficients, in u and v.
inline std::array<Polynomial, 4> homogeneous(const WeightedNet<Rational>& x) {
  std::array<Polynomial, 4> result;
  x.points.each([&](std::size_t i, std::size_t j) {
    for (std::size_t d = 0; d < 3; ++d)
      result[d][{static_cast<int>(i), static_cast<int>(j), 0, 0}] = x.points[i][j][d];
  });
  x.weights.each([&](std::size_t i, std::size_t j) {
    result[3][{static_cast<int>(i), static_cast<int>(j), 0, 0}] = x.weights[i][j][0];
  });
  return result;
}

/// w^degree f(X / w), of degree at most 4: the sum of c X^i Y^j Z^k w^(degree - i - j - k), by Horner's rule
/// in X, its coefficients likewise in Y and Z.
class Section {
 public:
  Section(const SurfaceEquation& f, const WeightedNet<Rational>& x) : f_(f), x_(homogeneous(x)) {
    powers_[0] = {{Power{}, 1}};
    for (std::size_t n = 1; n < powers_.size(); ++n) powers_[n] = product(powers_[n - 1], x_[3]);
  }
  Polynomial polynomial() const { return sum({}, 0, degree(f_)); }

 private:
  /// Of all monomials with these first `known` exponents, divided by them: homogeneous of degree `rest`.
  Polynomial sum(std::array<int, 3> power, std::size_t known, int rest) const {
    Polynomial result;
    if (known == 3) {
      const auto c = f_.find(power);
      if (c == f_.end() || c->second == 0) return {};
      return product({{Power{}, c->second}}, powers_[static_cast<std::size_t>(rest)]);
    }
    for (int n = rest; n >= 0; --n) {
      power[known] = n;
      if (!result.empty()) result = product(result, x_[known]);
      add(result, sum(power, known + 1, rest - n), 1);
    }
    return result;
  }

  const SurfaceEquation& f_;
  std::array<Polynomial, 4> x_;
  std::array<Polynomial, max_equation_degree + 1> powers_;  // of w
};

/// F of the polynomial in u and v.
inline Map<Rational> section_map(const Polynomial& section) {
  Map<Rational> map;
  for (const auto& [power, c] : section) map.coefficient(power)[0] = c;
  map.coefficient({0, 0, 1, 0})[1] = 1;
  map.coefficient({0, 0, 0, 1})[2] = 1;
  map.coefficient({})[1] = map.coefficient({})[2] = Rational(-1, 2);
  return map;
}

/// Bernstein coefficients of a polynomial in u and v.
template <class N>
using SectionNet = Grid<N, 1, 3 * max_equation_degree>;

/// Those over [0,1]^2 of a polynomial of degree at most m in u and n in v.
inline SectionNet<Rational> section_net(const Polynomial& section, std::size_t m, std::size_t n) {
  SectionNet<Rational> result(m, n);
  for (const auto& [power, c] : section)
    if (c != 0) result[static_cast<std::size_t>(power[0])][static_cast<std::size_t>(power[1])][0] = c;
  result.from_powers();
  return result;
}

}  // namespace exsect::checker
