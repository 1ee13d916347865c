#include "nearest_double.h"

namespace exsect {

NearestDouble nearest_double(const Rational& q) {
  const std::size_t bits = mpz_sizeinbase(mpq_denref(q.backend().data()), 2);
  const bool exact = mpz_sizeinbase(mpq_numref(q.backend().data()), 2) <= 53 && bits <= 1000 &&
                     mpz_scan1(mpq_denref(q.backend().data()), 0) == bits - 1;
  return {to_double(q), exact};
}

}  // namespace exsect
