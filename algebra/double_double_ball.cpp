#include "double_double_ball.h"

#include <optional>

#include "nearest_double.h"

namespace exsect {

namespace {

/// The remainder n - h d, where h is n/d rounded, for integers of at most 53 bits: it is a double.
std::optional<DoubleDoubleBall> short_fraction(const Rational& q) {
  const mpz_srcptr n = mpq_numref(q.backend().data());
  const mpz_srcptr d = mpq_denref(q.backend().data());
  if (mpz_sizeinbase(n, 2) > 53 || mpz_sizeinbase(d, 2) > 53) return std::nullopt;
  const double denominator = mpz_get_d(d);
  const double hi = mpz_get_d(n) / denominator;
  const double lo = std::fma(-hi, denominator, mpz_get_d(n)) / denominator;
  return DoubleDoubleBall::sum(hi, lo).widened(std::fabs(lo) * 0x1p-53);
}

}  // namespace

DoubleDoubleBall DoubleDoubleBall::enclosing(const Rational& q) {
  const NearestDouble nearest = nearest_double(q);
  if (nearest.exact) return nearest.value;
  if (const auto fraction = short_fraction(q)) return *fraction;
  const double hi = nearest.value;
  const Rational rest = q - from_double(hi);
  const double lo = to_double(rest);
  // Nearest rounding: the error is at most u|lo|, or 2^-1075 below the normal range.
  const DoubleDoubleBall mid = sum(hi, lo);
  return from_double(lo) == rest ? mid : mid.widened(std::fabs(lo) * 0x1p-53);
}

DoubleDoubleBall DoubleDoubleBall::enclosing(const RationalInterval& interval) {
  const DoubleDoubleBall centre = enclosing(interval.midpoint());
  const DoubleDoubleBall half = enclosing(interval.width() / 2);
  return centre.widened(half.upper_magnitude());
}

RationalInterval DoubleDoubleBall::interval() const {
  const Rational mid = from_double(hi_) + from_double(lo_);
  const Rational rad = from_double(rad_);
  return {mid - rad, mid + rad};
}

}  // namespace exsect
