#include "bernstein.h"

#include <stdexcept>

#include "flint_bernstein.h"
#include "flint_polynomial.h"

namespace exsect {
namespace {

std::size_t index(slong i) { return static_cast<std::size_t>(i); }

/// numerators[i] / denominator = coefficients[i].
void to_common_denominator(FlintVector& numerators, fmpz_t denominator,
                           const std::vector<Rational>& coefficients) {
  FlintInteger part;
  fmpz_one(denominator);
  for (const Rational& c : coefficients) {
    fmpz_set_mpz(part.value, mpq_denref(c.backend().data()));
    fmpz_lcm(denominator, denominator, part.value);
  }
  for (slong i = 0; i < numerators.size; ++i) {
    const mpq_srcptr c = coefficients[index(i)].backend().data();
    fmpz_set_mpz(part.value, mpq_denref(c));
    fmpz_divexact(part.value, denominator, part.value);
    fmpz_set_mpz(numerators[i], mpq_numref(c));
    fmpz_mul(numerators[i], numerators[i], part.value);
  }
}

Rational quotient(const fmpz_t numerator, const fmpz_t denominator) {
  FlintRational result;
  fmpq_set_fmpz_frac(result.value, numerator, denominator);
  return result.to_rational();
}

}  // namespace

void substitute_affine(fmpz_poly_t result, const fmpz_poly_t f, const fmpz_t p, const fmpz_t w,
                       const fmpz_t q) {
  fmpz_poly_set(result, f);
  const slong length = result->length;
  FlintInteger power;
  if (!fmpz_is_one(q)) {
    fmpz_one(power.value);
    for (slong i = length - 2; i >= 0; --i) {
      fmpz_mul(power.value, power.value, q);
      fmpz_mul(result->coeffs + i, result->coeffs + i, power.value);
    }
  }
  if (!fmpz_is_zero(p)) _fmpz_poly_taylor_shift(result->coeffs, p, length);
  if (!fmpz_is_one(w)) {
    fmpz_one(power.value);
    for (slong i = 1; i < length; ++i) {
      fmpz_mul(power.value, power.value, w);
      fmpz_mul(result->coeffs + i, result->coeffs + i, power.value);
    }
  }
}

void to_homogeneous(FlintVector& c, const fmpz_poly_t f) {
  // t^j (t + (1-t))^(n-j): c_i = sum_{j <= i} f_j binom(n-j, i-j), a shift by 1 of the reversed polynomial.
  const slong n = c.size - 1;
  for (slong j = 0; j <= n; ++j)
    if (j < f->length)
      fmpz_set(c[n - j], f->coeffs + j);
    else
      fmpz_zero(c[n - j]);
  FlintInteger one;
  fmpz_one(one.value);
  _fmpz_poly_taylor_shift(c.data, one.value, c.size);
  _fmpz_poly_reverse(c.data, c.data, c.size, c.size);
}

void from_homogeneous(fmpz_poly_t f, const FlintVector& c) {
  fmpz_poly_fit_length(f, c.size);
  _fmpz_poly_reverse(f->coeffs, c.data, c.size, c.size);
  FlintInteger minus_one;
  fmpz_set_si(minus_one.value, -1);
  _fmpz_poly_taylor_shift(f->coeffs, minus_one.value, c.size);
  _fmpz_poly_reverse(f->coeffs, f->coeffs, c.size, c.size);
  _fmpz_poly_set_length(f, c.size);
  _fmpz_poly_normalise(f);
}

void bernstein_multipliers(FlintVector& multipliers) {
  const slong n = multipliers.size - 1;
  FlintInteger common;
  fmpz_one(common.value);
  for (slong i = 0; i <= n / 2; ++i) {
    fmpz_bin_uiui(multipliers[i], static_cast<ulong>(n), static_cast<ulong>(i));
    fmpz_lcm(common.value, common.value, multipliers[i]);
  }
  for (slong i = 0; i <= n / 2; ++i) {
    fmpz_divexact(multipliers[i], common.value, multipliers[i]);
    fmpz_set(multipliers[n - i], multipliers[i]);
  }
}

Integer binomial(int n, int k) {
  if (k < 0 || k > n) return 0;
  Integer result;
  mpz_bin_uiui(result.backend().data(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

std::vector<Rational> bernstein_coefficients(const Polynomial& f, int n, const Rational& a,
                                             const Rational& b) {
  if (n < f.degree()) throw std::invalid_argument("bernstein_coefficients: n is below the degree");
  if (a >= b) throw std::invalid_argument("bernstein_coefficients: a < b is required");
  if (f.is_zero()) return std::vector<Rational>(index(n + 1));
  const Integer common = lcm(denominator(a), denominator(b));
  const FlintInteger q(common), p(numerator(a * common)), w(numerator((b - a) * common));
  FlintPolynomial on_unit;
  substitute_affine(on_unit.value, NumeratorView(f).get(), p.value, w.value, q.value);
  FlintVector c(n + 1);
  to_homogeneous(c, on_unit.value);

  FlintInteger scale, denominator_i;
  fmpz_pow_ui(scale.value, q.value, static_cast<ulong>(f.degree()));
  fmpz_mul(scale.value, scale.value, f.rep().value->den);
  std::vector<Rational> result;
  result.reserve(index(n + 1));
  for (slong i = 0; i <= n; ++i) {
    fmpz_bin_uiui(denominator_i.value, static_cast<ulong>(n), static_cast<ulong>(i));
    fmpz_mul(denominator_i.value, denominator_i.value, scale.value);
    result.push_back(quotient(c[i], denominator_i.value));
  }
  return result;
}

Polynomial from_bernstein(const std::vector<Rational>& coefficients) {
  if (coefficients.empty()) return {};
  const auto length = static_cast<slong>(coefficients.size());
  FlintVector c(length);
  FlintInteger common, factor;
  to_common_denominator(c, common.value, coefficients);
  for (slong i = 0; i < length; ++i) {
    fmpz_bin_uiui(factor.value, static_cast<ulong>(length - 1), static_cast<ulong>(i));
    fmpz_mul(c[i], c[i], factor.value);
  }
  FlintPolynomial f;
  from_homogeneous(f.value, c);
  Polynomial result = to_polynomial(f.value);
  fmpq_poly_scalar_div_fmpz(result.rep().value, result.rep().value, common.value);
  return result;
}

BernsteinHalves split_bernstein(const std::vector<Rational>& coefficients, const Rational& t) {
  const auto length = static_cast<slong>(coefficients.size());
  BernsteinHalves halves;
  if (length == 0) return halves;
  // b_i^(j+1) = (1-t) b_i^(j) + t b_(i+1)^(j) with t = p/q, on integers: the j-th row has the denominator D
  // q^j.
  const FlintInteger p(numerator(t)), q(denominator(t)), rest(denominator(t) - numerator(t));
  FlintVector row(length);
  FlintVector scales(length);
  to_common_denominator(row, scales[0], coefficients);
  for (slong j = 1; j < length; ++j) fmpz_mul(scales[j], scales[j - 1], q.value);
  halves.left.reserve(index(length));
  halves.left.push_back(coefficients.front());
  for (slong j = 1; j < length; ++j) {
    for (slong i = 0; i < length - j; ++i) {
      fmpz_mul(row[i], row[i], rest.value);
      fmpz_addmul(row[i], row[i + 1], p.value);
    }
    halves.left.push_back(quotient(row[0], scales[j]));
  }
  halves.right.reserve(index(length));
  for (slong i = 0; i < length; ++i) halves.right.push_back(quotient(row[i], scales[length - 1 - i]));
  return halves;
}

int sign_variations(const std::vector<Rational>& coefficients) {
  int variations = 0;
  int last = 0;
  for (const Rational& c : coefficients) {
    const int s = c.sign();
    if (s == 0) continue;
    if (last == -s) ++variations;
    last = s;
  }
  return variations;
}

}  // namespace exsect
