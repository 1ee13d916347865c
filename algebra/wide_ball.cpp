#include "wide_ball.h"

#include <cmath>

namespace exsect {

namespace {

/// Radii are sums of at most 2^20 nonnegative terms of at most three rounded factors each: less than this is
/// lost; 2^-1000 covers underflow.
double up(double r) { return r * (1 + 0x1p-30) + 0x1p-1000; }

/// The error of one term is at most 6 units of the sum, less than 2^4.
constexpr int kTermBits = 4;

}  // namespace

WideBall::WideBall(double x) {
  if (x == 0) return;
  int exponent = 0;
  const double fraction = std::frexp(std::fabs(x), &exponent);
  limbs_[kLimbs - 1] = static_cast<std::uint64_t>(std::ldexp(fraction, 64));
  exponent_ = exponent;
  negative_ = x < 0;
  magnitude_ = std::fabs(x);
}

WideBall WideBall::enclosing(const Integer& n, long exponent) {
  WideBall result;
  if (n == 0) return result;
  Integer rest = abs(n);
  const auto bits = static_cast<std::int64_t>(msb(rest)) + 1;
  if (bits > 256) {
    rest >>= static_cast<unsigned>(bits - 256);
  } else {
    rest <<= static_cast<unsigned>(256 - bits);
  }
  for (std::uint64_t& limb : result.limbs_) {
    limb = static_cast<std::uint64_t>(rest & Integer(~std::uint64_t{0}));
    rest >>= 64;
  }
  result.exponent_ = bits + exponent;
  result.negative_ = n < 0;
  result.set_magnitude();
  result.radius_ = bits > 256 ? power(result.exponent_ - 256) : 0;
  return result;
}

WideBall WideBall::enclosing(const RationalInterval& interval) {
  const Rational mid = interval.midpoint();
  const Integer denominator = boost::multiprecision::denominator(mid);
  const Integer numerator = boost::multiprecision::numerator(mid);
  const long shift = 320 + static_cast<long>(msb(denominator));
  WideBall result = enclosing(Integer((numerator << static_cast<unsigned>(shift)) / denominator), -shift);
  // One unit of 2^-shift is lost by the division.
  result.radius_ = up(result.radius_ + power(-shift) + to_double(interval.width()) * (0.5 + 0x1p-50));
  return result;
}

RationalInterval WideBall::interval() const {
  Integer n = 0;
  for (std::size_t i = kLimbs; i-- > 0;) n = (n << 64) + limbs_[i];
  const Rational mid =
      Rational(negative_ ? Integer(-n) : n) * power_of_two(static_cast<long>(exponent_) - 256);
  const Rational radius = from_double(radius_);
  return {mid - radius, mid + radius};
}

void WideBall::Sum::align_far(Term& term, std::int64_t by) {
  if (by > 0) {
    for (; by >= 64; by -= 64) {
      if (by >= 256) {
        term.n0 = term.n1 = term.n2 = term.n3 = 0;
        return;
      }
      term.n0 = term.n1;
      term.n1 = term.n2;
      term.n2 = term.n3;
      term.n3 = 0;
    }
    if (by > 0) align(term, by);
    return;
  }
  exponent_ = term.exponent;
  const std::uint64_t fill = top_ >> 63 != 0 ? ~std::uint64_t{0} : 0;
  by = std::min<std::int64_t>(-by, 320);
  for (; by >= 64; by -= 64) {
    n0_ = n1_;
    n1_ = n2_;
    n2_ = n3_;
    n3_ = top_;
    top_ = fill;
  }
  if (by == 0) return;
  n0_ = joined(n0_, n1_, by);
  n1_ = joined(n1_, n2_, by);
  n2_ = joined(n2_, n3_, by);
  n3_ = joined(n3_, top_, by);
  top_ = joined(top_, fill, by);
}

WideBall WideBall::Sum::rounded() const {
  WideBall result;
  result.radius_ = terms_ == 0 ? radius_ : radius_ + terms_ * power(exponent_ - 256 + kTermBits);
  const std::uint64_t mask = top_ >> 63 != 0 ? ~std::uint64_t{0} : 0;
  Term n = {n0_ ^ mask, n1_ ^ mask, n2_ ^ mask, n3_ ^ mask, exponent_, mask != 0};
  std::uint64_t top = top_ ^ mask;
  // The negative is the complement and one more.
  if (mask != 0 && ++n.n0 == 0 && ++n.n1 == 0 && ++n.n2 == 0 && ++n.n3 == 0) ++top;
  if (top != 0) {
    const int by = 64 - std::countl_zero(top);  // below 64: the top limb is a few terms at most
    n = {joined(n.n0, n.n1, by), joined(n.n1, n.n2, by), joined(n.n2, n.n3, by),
         joined(n.n3, top, by),  exponent_ + by,         n.negative};
    result.radius_ += power(n.exponent - 256);
  }
  for (int limb = 0; limb < 3 && n.n3 == 0; ++limb) {
    n = {0, n.n0, n.n1, n.n2, n.exponent - 64, n.negative};
  }
  if (n.n3 != 0) {
    if (const int by = std::countl_zero(n.n3); by > 0) {
      n = {n.n0 << by,
           joined(n.n0, n.n1, 64 - by),
           joined(n.n1, n.n2, 64 - by),
           joined(n.n2, n.n3, 64 - by),
           n.exponent - by,
           n.negative};
    }
    result.limbs_ = {n.n0, n.n1, n.n2, n.n3};
    result.exponent_ = n.exponent;
    result.negative_ = n.negative;
    result.set_magnitude();
  }
  result.radius_ = up(result.radius_);
  return result;
}

WideBall scaled(const WideBall& a, int k) {
  WideBall result = a;
  if (!a.is_zero()) {
    result.exponent_ += k;
    result.set_magnitude();
  }
  result.radius_ = a.radius_ == 0 ? 0 : up(a.radius_ * WideBall::power(k));
  return result;
}

/// floor((2^512 - 1) / n), n of 256 bits, for 2^512 / n: at most one unit less. For the midpoint b,
/// |1/a - 1/b| <= rad / (|b| (|b| - rad)).
WideBall inverse(const WideBall& a) {
  const double least = a.lower_magnitude();
  if (!(least > 0)) return {{}, 0, false, 0, std::numeric_limits<double>::infinity()};
  constexpr mp_size_t n = WideBall::kLimbs;
  std::array<mp_limb_t, 2 * n> all;
  all.fill(~mp_limb_t{0});
  std::array<mp_limb_t, n + 1> quotient;  // from 2^256 to 2^257
  std::array<mp_limb_t, n> remainder;
  mpn_tdiv_qr(quotient.data(), remainder.data(), 0, all.data(), 2 * n, a.limbs_.data(), n);
  WideBall result;
  // All bits but the last, of 257; 2^256 itself becomes 2^257 / 2.
  mpn_rshift(quotient.data(), quotient.data(), n + 1, 1);
  std::copy_n(quotient.begin(), n, result.limbs_.begin());
  result.exponent_ = 1 - a.exponent_;
  result.negative_ = a.negative_;
  result.set_magnitude();
  const double spread = a.radius_ / least / (a.magnitude_ * (1 - 0x1p-50));
  result.radius_ = up(4 * WideBall::power(result.exponent_ - 256) + spread);
  return result;
}

}  // namespace exsect
