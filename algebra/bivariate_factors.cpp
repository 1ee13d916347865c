#include "bivariate_factors.h"

#include <stdexcept>

#include "flint_bivariate.h"
#include "interruption.h"
// after flint.h
#include <flint/fmpq_mpoly_factor.h>

namespace exsect {

std::vector<BivariatePower> irreducible_factors(const BivariatePolynomial& f) {
  if (f.is_zero()) throw std::domain_error("irreducible_factors: the polynomial is zero");
  interruption_point();
  const BivariateContext ring;
  const FlintBivariate value(ring, f);
  fmpq_mpoly_factor_t factors;
  fmpq_mpoly_factor_init(factors, ring.get());
  const bool done = fmpq_mpoly_factor(factors, value.value, ring.get()) != 0;
  std::vector<BivariatePower> result;
  FlintBivariate factor(ring);
  for (slong i = 0; done && i < fmpq_mpoly_factor_length(factors, ring.get()); ++i) {
    fmpq_mpoly_factor_get_base(factor.value, factors, i, ring.get());
    fmpq_one(factor.value->content);
    result.push_back(
        {factor.to_bivariate(), static_cast<int>(fmpq_mpoly_factor_get_exp_si(factors, i, ring.get()))});
  }
  fmpq_mpoly_factor_clear(factors, ring.get());
  if (!done) throw std::runtime_error("irreducible_factors: the bivariate factorisation failed");
  return result;
}

}  // namespace exsect
