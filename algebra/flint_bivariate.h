// BivariatePolynomial as a FLINT multivariate polynomial over Q, lexicographic with r > s. Not a public
// header.
#pragma once

#include "bivariate_polynomial.h"
#include "flint.h"
// after flint.h
#include <flint/fmpq_mpoly.h>

namespace exsect {

/// The ring Q[r,s].
class BivariateContext {
 public:
  static constexpr slong r = 0;
  static constexpr slong s = 1;

  BivariateContext() { fmpq_mpoly_ctx_init(context_, 2, ORD_LEX); }
  ~BivariateContext() { fmpq_mpoly_ctx_clear(context_); }
  BivariateContext(const BivariateContext&) = delete;
  BivariateContext& operator=(const BivariateContext&) = delete;

  const fmpq_mpoly_ctx_struct* get() const { return context_; }

 private:
  fmpq_mpoly_ctx_t context_;
};

/// Owner of one element of Q[r,s]; the context must outlive it.
class FlintBivariate {
 public:
  explicit FlintBivariate(const BivariateContext& ring) : ring_(ring) { fmpq_mpoly_init(value, ring_.get()); }
  FlintBivariate(const BivariateContext& ring, const BivariatePolynomial& f);
  ~FlintBivariate() { fmpq_mpoly_clear(value, ring_.get()); }
  FlintBivariate(const FlintBivariate&) = delete;
  FlintBivariate& operator=(const FlintBivariate&) = delete;

  BivariatePolynomial to_bivariate() const;

  fmpq_mpoly_t value;

 private:
  const BivariateContext& ring_;
};

}  // namespace exsect
