// The Bernstein basis on integer coefficient vectors. Not a public header.
#pragma once

#include "flint.h"

namespace exsect {

/// Owner of `size` integers, zero at first.
struct FlintVector {
  fmpz* data;
  slong size;

  explicit FlintVector(slong length) : data(_fmpz_vec_init(length)), size(length) {}
  ~FlintVector() { _fmpz_vec_clear(data, size); }
  FlintVector(const FlintVector&) = delete;
  FlintVector& operator=(const FlintVector&) = delete;
  fmpz* operator[](slong i) { return data + i; }
  const fmpz* operator[](slong i) const { return data + i; }
};

/// result(t) = q^n f((p + w t) / q), n = deg f. Requires q > 0, w != 0. No aliasing.
void substitute_affine(fmpz_poly_t result, const fmpz_poly_t f, const fmpz_t p, const fmpz_t w,
                       const fmpz_t q);

/// The c_i, i = 0..n, with f = sum c_i t^i (1-t)^(n-i): the Bernstein coefficients times binom(n,i). The
/// vector has length n + 1 > deg f.
void to_homogeneous(FlintVector& c, const fmpz_poly_t f);

/// The inverse of to_homogeneous.
void from_homogeneous(fmpz_poly_t f, const FlintVector& c);

/// lcm_j binom(n,j) / binom(n,i), i = 0..n = size - 1: c_i times these are Bernstein coefficients up to one
/// positive factor.
void bernstein_multipliers(FlintVector& multipliers);

}  // namespace exsect
