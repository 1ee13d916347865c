#include "number_field.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include "flint_polynomial.h"
#include "interruption.h"

// after flint.h, which includes what this needs
#include <flint/nmod_poly_factor.h>

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
    interruption_point();
    const Polynomial leading = f.back();
    const std::size_t shift = f.size() - h.size();
    for (std::size_t i = 0; i < h.size(); ++i)
      f[shift + i] = divide(f[shift + i] - leading * h[i], g).remainder;
    while (!f.empty() && f.back().is_zero()) f.pop_back();
  }
}

constexpr int kPrimesTried = 24;

struct ResiduePolynomial {
  nmod_poly_t value;
  explicit ResiduePolynomial(mp_limb_t prime) { nmod_poly_init(value, prime); }
  ~ResiduePolynomial() { nmod_poly_clear(value); }
  ResiduePolynomial(const ResiduePolynomial&) = delete;
  ResiduePolynomial& operator=(const ResiduePolynomial&) = delete;
};

/// A root of g modulo the prime, if there is one and the leading coefficient is not zero.
std::optional<mp_limb_t> root_modulo(const Polynomial& g, mp_limb_t prime) {
  ResiduePolynomial image(prime);
  fmpz_poly_get_nmod_poly(image.value, NumeratorView(g).get());
  if (nmod_poly_degree(image.value) != g.degree()) return std::nullopt;
  nmod_poly_factor_t roots;
  nmod_poly_factor_init(roots);
  nmod_poly_roots(roots, image.value, 0);
  std::optional<mp_limb_t> root;
  if (roots->num > 0) root = n_negmod(nmod_poly_get_coeff_ui(&roots->p[0], 0), prime);
  nmod_poly_factor_clear(roots);
  return root;
}

/// Sets `image` to f(r,s) modulo its prime; false if a denominator vanishes.
bool set_image(ResiduePolynomial& image, const BivariatePolynomial& f, mp_limb_t s) {
  const mp_limb_t prime = image.value->mod.n;
  ResiduePolynomial coefficient(prime);
  for (int i = 0; i <= f.degree_r(); ++i) {
    const Polynomial c = f.coefficient(i);
    const mp_limb_t denominator = fmpz_fdiv_ui(fmpq_poly_denref(c.rep().value), prime);
    if (denominator == 0) return false;
    fmpz_poly_get_nmod_poly(coefficient.value, NumeratorView(c).get());
    const mp_limb_t value = nmod_poly_evaluate_nmod(coefficient.value, s);
    nmod_poly_set_coeff_ui(image.value, i,
                           nmod_mul(value, nmod_inv(denominator, image.value->mod), image.value->mod));
  }
  return true;
}

}  // namespace

// Let O be a valuation ring of Q[s]/(g) over the prime in whose residue field s is the root (s is integral:
// the leading coefficient of g is a unit). Divided by its content the divisor divides f and h over O (Gauss),
// its leading coefficient divides one that is a unit, and its image divides both images.
std::optional<int> gcd_degree_bound(const BivariatePolynomial& f, const BivariatePolynomial& h,
                                    const Polynomial& g) {
  if (g.degree() < 1) throw std::domain_error("a field modulo a constant");
  mp_limb_t prime = mp_limb_t{1} << 59U;
  for (int tried = 0; tried < kPrimesTried; ++tried) {
    prime = n_nextprime(prime, 1);
    const auto root = root_modulo(g, prime);
    if (!root) continue;
    ResiduePolynomial first(prime), second(prime);
    if (!set_image(first, f, *root) || !set_image(second, h, *root)) continue;
    const bool keeps_degree = (!f.is_zero() && nmod_poly_degree(first.value) == f.degree_r()) ||
                              (!h.is_zero() && nmod_poly_degree(second.value) == h.degree_r());
    if (!keeps_degree) continue;
    nmod_poly_gcd(first.value, first.value, second.value);
    return static_cast<int>(nmod_poly_degree(first.value));
  }
  return std::nullopt;
}

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
    interruption_point();
    if (!make_monic(b, g)) return std::nullopt;
    reduce(a, b, g);
    std::swap(a, b);
  }
  if (!a.empty() && !make_monic(a, g)) return std::nullopt;
  return BivariatePolynomial(std::move(a));
}

}  // namespace exsect
