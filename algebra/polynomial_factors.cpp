// Greatest common divisors, squarefree parts and factorisations in Q[t].
#include <algorithm>
#include <stdexcept>
#include <string>

#include "flint_polynomial.h"
#include "interruption.h"
#include "polynomial.h"

namespace exsect {
namespace {

/// The largest primes below 2^63, 2^62, 2^61.
constexpr mp_limb_t test_primes[] = {9223372036854775783ULL, 4611686018427387847ULL, 2305843009213693951ULL};

struct FlintModularPolynomial {
  nmod_poly_t value;

  explicit FlintModularPolynomial(mp_limb_t prime) { nmod_poly_init(value, prime); }
  ~FlintModularPolynomial() { nmod_poly_clear(value); }
  FlintModularPolynomial(const FlintModularPolynomial&) = delete;
  FlintModularPolynomial& operator=(const FlintModularPolynomial&) = delete;
};

/// True proves f squarefree: if p does not divide the leading coefficient, deg gcd(f, f') over Q is at most
/// the degree of the gcd modulo p. False proves nothing.
bool squarefree_modulo_prime(const fmpz_poly_t f) {
  for (const mp_limb_t p : test_primes) {
    if (fmpz_fdiv_ui(fmpz_poly_lead(f), p) == 0) continue;
    FlintModularPolynomial reduced(p), derivative(p), common(p);
    fmpz_poly_get_nmod_poly(reduced.value, f);
    nmod_poly_derivative(derivative.value, reduced.value);
    nmod_poly_gcd(common.value, reduced.value, derivative.value);
    return nmod_poly_length(common.value) == 1;
  }
  return false;
}

void require_nonzero(const Polynomial& f, const char* what) {
  if (f.is_zero()) throw std::domain_error(std::string(what) + ": the polynomial is zero");
}

std::vector<PolynomialPower> to_powers(const fmpz_poly_factor_t factorisation) {
  std::vector<PolynomialPower> result;
  for (slong i = 0; i < factorisation->num; ++i)
    result.push_back({to_polynomial(factorisation->p + i), static_cast<int>(factorisation->exp[i])});
  std::stable_sort(result.begin(), result.end(), [](const PolynomialPower& a, const PolynomialPower& b) {
    return a.multiplicity < b.multiplicity;
  });
  return result;
}

struct FlintFactorisation {
  fmpz_poly_factor_t value;

  FlintFactorisation() { fmpz_poly_factor_init(value); }
  ~FlintFactorisation() { fmpz_poly_factor_clear(value); }
  FlintFactorisation(const FlintFactorisation&) = delete;
  FlintFactorisation& operator=(const FlintFactorisation&) = delete;
};

}  // namespace

Polynomial gcd(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  fmpq_poly_gcd(result.rep().value, a.rep().value, b.rep().value);
  return result;
}

bool is_squarefree(const Polynomial& f) {
  require_nonzero(f, "is_squarefree");
  if (f.degree() <= 1) return true;
  const NumeratorView numerator(f);
  return squarefree_modulo_prime(numerator.get()) || fmpz_poly_is_squarefree(numerator.get()) != 0;
}

Polynomial squarefree_part(const Polynomial& f) {
  require_nonzero(f, "squarefree_part");
  FlintPolynomial part;
  fmpz_poly_set(part.value, NumeratorView(f).get());
  make_primitive(part.value);
  if (f.degree() > 1 && !squarefree_modulo_prime(part.value)) {
    FlintPolynomial common;
    fmpz_poly_derivative(common.value, part.value);
    // The gcd of a primitive polynomial is primitive, its leading coefficient positive: the quotient is
    // primitive and keeps the sign.
    fmpz_poly_gcd(common.value, part.value, common.value);
    fmpz_poly_div(part.value, part.value, common.value);
  }
  return to_polynomial(part.value);
}

std::vector<PolynomialPower> squarefree_factors(const Polynomial& f) {
  require_nonzero(f, "squarefree_factors");
  FlintFactorisation factorisation;
  fmpz_poly_factor_squarefree(factorisation.value, NumeratorView(f).get());
  return to_powers(factorisation.value);
}

std::vector<PolynomialPower> irreducible_factors(const Polynomial& f) {
  require_nonzero(f, "irreducible_factors");
  interruption_point();
  FlintFactorisation factorisation;
  fmpz_poly_factor(factorisation.value, NumeratorView(f).get());
  return to_powers(factorisation.value);
}

}  // namespace exsect
