// Polynomial seen from inside algebra/: its fmpq_poly, and owners of integer polynomials. Not a public
// header.
#pragma once

#include "flint.h"
#include "polynomial.h"

namespace exsect {

struct Polynomial::Rep {
  fmpq_poly_t value;

  Rep() { fmpq_poly_init(value); }
  Rep(const Rep& other) {
    fmpq_poly_init2(value, fmpq_poly_length(other.value));
    fmpq_poly_set(value, other.value);
  }
  Rep& operator=(const Rep& other) {
    fmpq_poly_set(value, other.value);
    return *this;
  }
  ~Rep() { fmpq_poly_clear(value); }
};

/// Owner of one fmpz_poly.
struct FlintPolynomial {
  fmpz_poly_t value;

  FlintPolynomial() { fmpz_poly_init(value); }
  ~FlintPolynomial() { fmpz_poly_clear(value); }
  FlintPolynomial(const FlintPolynomial&) = delete;
  FlintPolynomial& operator=(const FlintPolynomial&) = delete;
};

/// The numerator of f = numerator / denominator as an fmpz_poly that shares the coefficients of f: read only,
/// valid as long as f is alive and unchanged.
class NumeratorView {
 public:
  explicit NumeratorView(const Polynomial& f) {
    value_->coeffs = f.rep().value->coeffs;
    value_->alloc = f.rep().value->alloc;
    value_->length = f.rep().value->length;
  }
  const fmpz_poly_struct* get() const { return value_; }

 private:
  fmpz_poly_t value_;
};

/// The polynomial with the same coefficients.
inline Polynomial to_polynomial(const fmpz_poly_t f) {
  Polynomial result;
  fmpq_poly_set_fmpz_poly(result.rep().value, f);
  return result;
}

/// f divided by its positive content; zero for zero.
inline void make_primitive(fmpz_poly_t f) {
  FlintInteger content;
  fmpz_poly_content(content.value, f);
  if (!fmpz_is_zero(content.value) && !fmpz_is_one(content.value))
    fmpz_poly_scalar_divexact_fmpz(f, f, content.value);
}

}  // namespace exsect
