#include "number_field.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include "flint_polynomial.h"

namespace exsect {

namespace {

using Coefficients = std::vector<Polynomial>;  // of 1, r, r², ..., the last one not zero

Coefficients reduced(const BivariatePolynomial& f, const Polynomial& g) {
  Coefficients result;
  for (int i = 0; i <= f.degree_r(); ++i) result.push_back(divide(f.coefficient(i), g).remainder);
  while (!result.empty() && result.back().is_zero()) result.pop_back();
  return result;
}

/// False if the leading coefficient has no inverse.
bool make_monic(Coefficients& f, const Polynomial& g) {
  const auto inverse = inverse_modulo(f.back(), g);
  if (!inverse) return false;
  for (Polynomial& c : f) c = divide(c * *inverse, g).remainder;
  return true;
}

/// f modulo the monic h.
void reduce(Coefficients& f, const Coefficients& h, const Polynomial& g) {
  while (f.size() >= h.size()) {
    const Polynomial leading = f.back();
    const std::size_t shift = f.size() - h.size();
    for (std::size_t i = 0; i < h.size(); ++i)
      f[shift + i] = divide(f[shift + i] - leading * h[i], g).remainder;
    while (!f.empty() && f.back().is_zero()) f.pop_back();
  }
}

}  // namespace

std::optional<Polynomial> inverse_modulo(const Polynomial& a, const Polynomial& g) {
  if (g.degree() < 1) throw std::domain_error("an inverse modulo a constant");
  const Polynomial reduced = divide(a, g).remainder;
  if (reduced.is_zero()) return std::nullopt;
  Polynomial common, inverse, rest;
  fmpq_poly_xgcd(common.rep().value, inverse.rep().value, rest.rep().value, reduced.rep().value,
                 g.rep().value);
  if (common.degree() > 0) return std::nullopt;
  return inverse;  // common is monic
}

std::optional<BivariatePolynomial> gcd_modulo(const BivariatePolynomial& f, const BivariatePolynomial& h,
                                              const Polynomial& g) {
  Coefficients a = reduced(f, g);
  Coefficients b = reduced(h, g);
  while (!b.empty()) {
    if (!make_monic(b, g)) return std::nullopt;
    reduce(a, b, g);
    std::swap(a, b);
  }
  if (!a.empty() && !make_monic(a, g)) return std::nullopt;
  return BivariatePolynomial(std::move(a));
}

}  // namespace exsect
