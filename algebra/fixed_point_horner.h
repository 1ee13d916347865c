// Horner's rule at dyadic points in fixed point with a proved error: many times faster than floating balls.
// Not a public header.
#pragma once

#include <vector>

#include "flint.h"

namespace exsect {

/// The polynomial sum c_i x^i with integer coefficients, not all zero, on |x| < 2^scale. The coefficients
/// must outlive it.
///
/// With y = x / 2^scale and c_i' = c_i 2^(scale i) all steps of Horner's rule in y are below 2^(top - 2) in
/// absolute value, 2^top > 4 (n+1) max |c_i'|. They are kept as two's complement multiples of one unit
/// 2^(top - 64 limbs). Coefficients are rounded down to units: error in [0,1). y is exact; a step multiplies
/// the error by |y| < 1, rounds the product down and adds a coefficient: the error of a step is below that of
/// the one before plus 2, that of the value below 2 (n+1) units.
class FixedPointHorner {
 public:
  FixedPointHorner(const fmpz* coefficients, slong degree, slong scale);

  /// Sets `value` to a ball that contains the value at numerator / 2^exponent, |numerator / 2^exponent| <
  /// 2^scale.
  void evaluate(arb_t value, const fmpz_t numerator, slong exponent, slong limbs);
  slong top() const { return top_; }

 private:
  void extend(slong limbs);
  /// product_ = accumulator_ times point_, both signed by two's complement, and 0 <= point_.
  void multiply(slong limbs, slong point_limbs);

  const fmpz* coefficients_;
  slong degree_;
  slong scale_;
  slong top_;
  slong limbs_ = 0;
  std::vector<mp_limb_t>
      table_;  // limbs_ limbs for each coefficient; its upper limbs are the coarser roundings
  std::vector<mp_limb_t> accumulator_, product_, point_;
};

}  // namespace exsect
