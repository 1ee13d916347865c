// The one place that includes FLINT and Arb: FLINT 2.9 with Arb 2.23 beside it (Debian 12), or FLINT 3,
// which contains Arb. Internal to algebra/: no public header includes this file.
#pragma once

// clang-format off
#include <gmp.h>  // before any FLINT header, which then declare their functions on GMP types
#include <flint/flint.h>
// clang-format on

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_vec.h>
#include <flint/nmod_poly.h>
#include <flint/ulong_extras.h>

#if __FLINT_RELEASE >= 30000
#include <flint/arb.h>
#include <flint/arf.h>
#else
#include <arb.h>
#include <arf.h>
#endif

#include "rational.h"

namespace exsect {

/// Owner of one fmpz.
struct FlintInteger {
  fmpz_t value;
  FlintInteger() { fmpz_init(value); }
  explicit FlintInteger(const Integer& n) : FlintInteger() { fmpz_set_mpz(value, n.backend().data()); }
  ~FlintInteger() { fmpz_clear(value); }
  FlintInteger(const FlintInteger&) = delete;
  FlintInteger& operator=(const FlintInteger&) = delete;

  Integer to_integer() const {
    Integer result;
    fmpz_get_mpz(result.backend().data(), value);
    return result;
  }
};

/// Owner of one fmpq.
struct FlintRational {
  fmpq_t value;
  FlintRational() { fmpq_init(value); }
  explicit FlintRational(const Rational& q) : FlintRational() { fmpq_set_mpq(value, q.backend().data()); }
  ~FlintRational() { fmpq_clear(value); }
  FlintRational(const FlintRational&) = delete;
  FlintRational& operator=(const FlintRational&) = delete;

  Rational to_rational() const {
    Rational result;
    fmpq_get_mpq(result.backend().data(), value);
    return result;
  }
};

/// Owner of one arb.
struct FlintBall {
  arb_t value;
  FlintBall() { arb_init(value); }
  ~FlintBall() { arb_clear(value); }
  FlintBall(const FlintBall&) = delete;
  FlintBall& operator=(const FlintBall&) = delete;
};

/// Exact value of a finite arf.
inline Rational to_rational(const arf_struct* x) {
  FlintRational result;
  FlintInteger mantissa;
  FlintInteger exponent;
  arf_get_fmpz_2exp(mantissa.value, exponent.value, x);
  fmpz_set(fmpq_numref(result.value), mantissa.value);
  fmpz_one(fmpq_denref(result.value));
  if (fmpz_sgn(exponent.value) >= 0) {
    fmpq_mul_2exp(result.value, result.value, fmpz_get_ui(exponent.value));
  } else {
    fmpz_neg(exponent.value, exponent.value);
    fmpq_div_2exp(result.value, result.value, fmpz_get_ui(exponent.value));
  }
  return result.to_rational();
}

}  // namespace exsect
