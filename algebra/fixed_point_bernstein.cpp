#include "fixed_point_bernstein.h"

#include <algorithm>

namespace exsect {
namespace {

constexpr slong kept_bits = 124;

/// By how many bits the largest coefficient is too long.
slong excess_bits(const FlintVector& c) { return std::labs(_fmpz_vec_max_bits(c.data, c.size)) - kept_bits; }

Int128 to_int128(const fmpz_t n) {
  ulong high = 0;
  ulong low = 0;
  fmpz_get_signed_uiui(&high, &low, n);
  return static_cast<Int128>(high) << 64 | static_cast<Int128>(low);
}

}  // namespace

FixedPointBernstein::FixedPointBernstein(const FlintVector& exact)
    : zero_at_left_(fmpz_is_zero(exact[0]) != 0), zero_at_right_(fmpz_is_zero(exact[exact.size - 1]) != 0) {
  const slong excess = excess_bits(exact);
  coefficients_.resize(static_cast<std::size_t>(exact.size));
  FlintInteger scaled;
  for (slong i = 0; i < exact.size; ++i) {
    // Rounding down moves a coefficient by less than one unit; shifting up is exact.
    if (excess > 0)
      fmpz_fdiv_q_2exp(scaled.value, exact[i], static_cast<ulong>(excess));
    else
      fmpz_mul_2exp(scaled.value, exact[i], static_cast<ulong>(-excess));
    coefficients_[static_cast<std::size_t>(i)] = to_int128(scaled.value);
  }
  error_ = excess > 0 ? 1 : 0;
}

FixedPointBernstein::FixedPointBernstein(const FlintVector& middle, const fmpz_t error)
    : FixedPointBernstein(middle) {
  zero_at_left_ = zero_at_right_ = false;
  const slong excess = excess_bits(middle);
  FlintInteger units;
  if (excess > 0)
    fmpz_cdiv_q_2exp(units.value, error, static_cast<ulong>(excess));
  else
    fmpz_mul_2exp(units.value, error, static_cast<ulong>(-excess));
  constexpr slong hopeless = kept_bits + 1;  // no sign is certain
  if (fmpz_bits(units.value) > hopeless) fmpz_one_2exp(units.value, hopeless);
  error_ += to_int128(units.value);
}

FixedPointBernstein FixedPointBernstein::split() {
  // de Casteljau at 1/2. A mean of two coefficients inherits the larger of their errors, and rounding it down
  // adds at most 1/2; a coefficient of a half is at most n = size - 1 means deep, so the error grows by at
  // most n/2. Means do not exceed 2^124, and the sums of two fit.
  const std::size_t size = coefficients_.size();
  FixedPointBernstein left;
  left.coefficients_.resize(size);
  left.error_ = error_ + static_cast<Int128>(size / 2);
  left.zero_at_left_ = zero_at_left_;
  Int128* const row = coefficients_.data();
  left.coefficients_[0] = row[0];
  for (std::size_t j = 1; j < size; ++j) {
    Int128 current = row[0];
    for (std::size_t i = 0; i < size - j; ++i) {
      const Int128 next = row[i + 1];
      row[i] = (current + next) >> 1;
      current = next;
    }
    left.coefficients_[j] = row[0];
  }
  error_ = left.error_;
  zero_at_left_ = false;
  return left;
}

VariationBounds FixedPointBernstein::variations() const {
  // most_if[s]: the most changes over all choices for the uncertain signs that end with the sign s; -1: none.
  int least = 0;
  int last_certain = 0;
  int most_if_plus = -1;
  int most_if_minus = -1;
  bool all_zero_possible = true;
  const std::size_t begin = zero_at_left_ ? 1 : 0;
  const std::size_t end = coefficients_.size() - (zero_at_right_ ? 1 : 0);
  for (std::size_t i = begin; i < end; ++i) {
    const int s = certain_sign(i);
    const int start = all_zero_possible ? 0 : -1;
    const int plus = std::max({most_if_plus, most_if_minus < 0 ? -1 : most_if_minus + 1, start});
    const int minus = std::max({most_if_minus, most_if_plus < 0 ? -1 : most_if_plus + 1, start});
    most_if_plus = s >= 0 ? plus : -1;
    most_if_minus = s <= 0 ? minus : -1;
    if (s == 0) continue;
    all_zero_possible = false;
    if (last_certain == -s) ++least;
    last_certain = s;
  }
  return {least, std::max({most_if_plus, most_if_minus, 0})};
}

bool FixedPointBernstein::ends_certain() const {
  return (zero_at_left_ || certain_sign(0) != 0) &&
         (zero_at_right_ || certain_sign(coefficients_.size() - 1) != 0);
}

}  // namespace exsect
