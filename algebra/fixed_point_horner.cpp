#include "fixed_point_horner.h"

#include <algorithm>

namespace exsect {
namespace {

bool is_negative(mp_limb_t upper) { return upper >> (FLINT_BITS - 1) != 0; }

/// The integer in two's complement times 2^exponent.
void set_from_limbs(arf_t value, mp_limb_t* limbs, slong size, slong exponent) {
  const bool negative = is_negative(limbs[size - 1]);
  if (negative) mpn_neg(limbs, limbs, size);
  while (size > 0 && limbs[size - 1] == 0) --size;
  if (size == 0) {
    arf_zero(value);
    return;
  }
  arf_set_mpn(value, limbs, size, negative);
  arf_mul_2exp_si(value, value, exponent);
}

}  // namespace

FixedPointHorner::FixedPointHorner(const fmpz* coefficients, slong degree, slong scale)
    : coefficients_(coefficients), degree_(degree), scale_(scale), top_(0) {
  bool first = true;
  for (slong i = 0; i <= degree; ++i) {
    if (fmpz_is_zero(coefficients + i)) continue;
    const slong bits = static_cast<slong>(fmpz_bits(coefficients + i)) + scale * i;
    top_ = first ? bits : std::max(top_, bits);
    first = false;
  }
  top_ += static_cast<slong>(FLINT_BIT_COUNT(static_cast<ulong>(degree + 1))) + 2;
}

void FixedPointHorner::extend(slong limbs) {
  if (limbs <= limbs_) return;
  limbs_ = limbs;
  table_.resize(static_cast<std::size_t>(limbs * (degree_ + 1)));
  FlintInteger units;
  for (slong i = 0; i <= degree_; ++i) {
    const slong shift = scale_ * i - top_ + FLINT_BITS * limbs;
    if (shift >= 0)
      fmpz_mul_2exp(units.value, coefficients_ + i, static_cast<ulong>(shift));
    else
      fmpz_fdiv_q_2exp(units.value, coefficients_ + i, static_cast<ulong>(-shift));
    fmpz_get_signed_ui_array(table_.data() + i * limbs, limbs, units.value);
  }
}

void FixedPointHorner::multiply(slong limbs, slong point_limbs) {
  mp_limb_t* const a = accumulator_.data();
  mp_limb_t* const p = product_.data();
  const mp_limb_t* const x = point_.data();
  if (point_limbs == 1)
    p[limbs] = mpn_mul_1(p, a, limbs, x[0]);
  else if (limbs >= point_limbs)
    mpn_mul(p, a, limbs, x, point_limbs);
  else
    mpn_mul(p, x, point_limbs, a, limbs);
  // The limbs read as an unsigned number are 2^(64 limbs) too large.
  if (is_negative(a[limbs - 1])) mpn_sub_n(p + limbs, p + limbs, x, point_limbs);
}

void FixedPointHorner::evaluate(arb_t value, const fmpz_t numerator, slong exponent, slong limbs) {
  extend(limbs);
  // |y| = |numerator| / 2^bits = point_ / 2^(64 point_limbs); bits <= 0 only for x = 0.
  const slong bits = std::max<slong>(1, exponent + scale_);
  const slong point_limbs = (bits + FLINT_BITS - 1) / FLINT_BITS;
  FlintInteger y;
  fmpz_abs(y.value, numerator);
  fmpz_mul_2exp(y.value, y.value, static_cast<ulong>(point_limbs * FLINT_BITS - bits));
  point_.resize(static_cast<std::size_t>(point_limbs));
  fmpz_get_ui_array(point_.data(), point_limbs, y.value);
  accumulator_.resize(static_cast<std::size_t>(limbs));
  product_.resize(static_cast<std::size_t>(limbs + point_limbs));

  const bool negative = fmpz_sgn(numerator) < 0;
  mp_limb_t* const accumulator = accumulator_.data();
  const mp_limb_t* coefficient = table_.data() + degree_ * limbs_ + (limbs_ - limbs);
  std::copy(coefficient, coefficient + limbs, accumulator);
  for (slong i = degree_ - 1; i >= 0; --i) {
    coefficient -= limbs_;
    multiply(limbs, point_limbs);
    if (negative)
      mpn_sub_n(accumulator, coefficient, product_.data() + point_limbs, limbs);
    else
      mpn_add_n(accumulator, coefficient, product_.data() + point_limbs, limbs);
  }
  const slong unit = top_ - FLINT_BITS * limbs;
  set_from_limbs(arb_midref(value), accumulator, limbs, unit);
  mag_set_ui_2exp_si(arb_radref(value), static_cast<ulong>(2 * (degree_ + 1)), unit);
}

}  // namespace exsect
