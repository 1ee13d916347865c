// Bernstein coefficients in 128-bit fixed point with a proved error bound. Not a public header.
#pragma once

#include <cstdint>
#include <vector>

#include "flint_bernstein.h"

namespace exsect {

__extension__ typedef __int128 Int128;

/// The least and the most sign changes that the true coefficients can have.
struct VariationBounds {
  int least;
  int most;
};

/// Coefficients a_i with |a_i - b_i / 2^e| <= error for the Bernstein coefficients b_i of a polynomial and
/// one exponent e; |a_i| <= 2^124. An end coefficient known to be zero exactly is marked.
class FixedPointBernstein {
 public:
  /// From exact integer coefficients, not all zero: rounded down to the leading 124 bits of the largest.
  explicit FixedPointBernstein(const FlintVector& exact);
  /// From coefficients that are known up to `error`; no end counts as known to be zero.
  FixedPointBernstein(const FlintVector& middle, const fmpz_t error);

  /// Keeps the right half [1/2,1] and returns the left half [0,1/2].
  FixedPointBernstein split();

  VariationBounds variations() const;
  /// Both ends are known to be zero or have a certain sign.
  bool ends_certain() const;
  bool zero_at_left() const { return zero_at_left_; }
  bool zero_at_right() const { return zero_at_right_; }
  /// Sign of the first coefficient that is not a zero end, 0 if uncertain.
  int sign_right_of_left_end() const { return certain_sign(zero_at_left_ ? 1 : 0); }

 private:
  FixedPointBernstein() = default;
  int certain_sign(std::size_t i) const {
    return coefficients_[i] > error_ ? 1 : coefficients_[i] < -error_ ? -1 : 0;
  }

  std::vector<Int128> coefficients_;
  Int128 error_ = 0;
  bool zero_at_left_ = false;
  bool zero_at_right_ = false;
};

}  // namespace exsect
