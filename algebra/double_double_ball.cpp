#include "double_double_ball.h"

namespace exsect {

DoubleDoubleBall DoubleDoubleBall::enclosing(const Rational& q) {
  const double hi = to_double(q);
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
