// Sizes of rational numbers by powers of two.
#pragma once

#include <exsect/algebra/rational.h>

namespace exsect {

/// n with 2^(n-1) < |q| < 2^(n+1), the difference of the bits of numerator and denominator. Requires q != 0.
inline long binary_order(const Rational& q) {
  const auto& data = q.backend().data();
  return static_cast<long>(mpz_sizeinbase(mpq_numref(data), 2)) -
         static_cast<long>(mpz_sizeinbase(mpq_denref(data), 2));
}

}  // namespace exsect
