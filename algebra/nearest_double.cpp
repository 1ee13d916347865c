#include "nearest_double.h"

#include <exsect/algebra/nearest_rounding.h>

#include <cmath>

namespace exsect {

NearestDouble nearest_double(const Rational& q) {
  const mpz_srcptr n = mpq_numref(q.backend().data());
  const mpz_srcptr d = mpq_denref(q.backend().data());
  if (mpz_sizeinbase(n, 2) > 53) return {to_double(q), false};
  const std::size_t bits = mpz_sizeinbase(d, 2);
  if (bits <= 1000 && mpz_scan1(d, 0) == bits - 1) {  // a power of two
    return {std::ldexp(mpz_get_d(n), 1 - static_cast<int>(bits)), true};
  }
  if (bits > 53) return {to_double(q), false};
  return {in_nearest_rounding([&] { return mpz_get_d(n) / mpz_get_d(d); }), false};  // of exact numbers
}

}  // namespace exsect
