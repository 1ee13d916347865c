#include "rational.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace exsect {
namespace {

Integer floored_quotient(const Integer& a, const Integer& b) {
  Integer result;
  mpz_fdiv_q(result.backend().data(), a.backend().data(), b.backend().data());
  return result;
}

/// 0 <= a < b. The continued fraction of the answer is the common beginning of those of a and b.
Rational simplest_between_positive(const Rational& a, const Rational& b) {
  const Integer whole = floored_quotient(numerator(a), denominator(a));
  if (Rational(whole + 1) < b) return whole + 1;
  // a and b lie in [whole, whole + 1]; b may be the upper end.
  const Rational low = a - whole;
  const Rational high = b - whole;
  if (low == 0) return whole + Rational(1, floored_quotient(denominator(high), numerator(high)) + 1);
  return whole + 1 / simplest_between_positive(1 / high, 1 / low);
}

/// mantissa 2^exponent for a result of at most 53 bits, infinite if it is too large. Put together bit by bit,
/// here and in from_double: so neither depends on the floating-point environment.
double double_of(std::uint64_t mantissa, long exponent, bool negative) {
  const int top = static_cast<int>(std::bit_width(mantissa));
  std::uint64_t bits = static_cast<std::uint64_t>(negative) << 63;
  if (exponent + top > 1024) {
    bits |= std::uint64_t{0x7ff} << 52;
  } else if (exponent + top > -1022) {  // normal: the first bit is not stored
    const int up = 53 - top;
    bits |= static_cast<std::uint64_t>(exponent - up + 1074) << 52;
    bits += up >= 0 ? mantissa << up : mantissa >> -up;
  } else {
    bits |= mantissa << (exponent + 1074);
  }
  return std::bit_cast<double>(bits);
}

/// mantissa 2^exponent rounded to nearest, ties to even, in integers: to 53 bits, or fewer below 2^-1022.
/// Requires at least 55 bits, or the exponent -1076.
double rounded_double(std::uint64_t mantissa, long exponent, bool negative) {
  const long excess = std::max(static_cast<long>(std::bit_width(mantissa)) - 53, -1074 - exponent);
  const std::uint64_t place = std::uint64_t{1} << excess;
  const std::uint64_t rest = mantissa & (place - 1);
  std::uint64_t rounded = mantissa >> excess;
  if (2 * rest > place || (2 * rest == place && (rounded & 1) != 0)) ++rounded;
  return double_of(rounded, exponent + excess, negative);
}

/// The leading 64 bits of n, which has more; the last of them is set if a further bit is, which keeps a tie
/// from looking exact.
std::uint64_t leading_bits(mpz_srcptr n) {
  static_assert(GMP_NUMB_BITS == 64);
  const std::size_t bits = mpz_sizeinbase(n, 2);
  const auto last = static_cast<mp_size_t>(mpz_size(n)) - 1;
  const std::size_t first = (bits - 1) % 64 + 1;  // bits of the leading limb
  std::uint64_t result = mpz_getlimbn(n, last) << (64 - first);
  if (first < 64) result |= mpz_getlimbn(n, last - 1) >> first;
  return result | static_cast<std::uint64_t>(mpz_scan1(n, 0) < bits - 64);
}

}  // namespace

int sign(const Rational& q) { return q.sign(); }

bool is_short_dyadic(const Rational& q) {
  const mpz_srcptr d = mpq_denref(q.backend().data());
  const std::size_t bits = mpz_sizeinbase(d, 2);
  return mpz_sizeinbase(mpq_numref(q.backend().data()), 2) <= 53 && bits <= 1000 &&
         mpz_scan1(d, 0) == bits - 1;
}

double to_double(const Rational& q) {
  const mpz_srcptr n = mpq_numref(q.backend().data());
  mpz_srcptr d = mpq_denref(q.backend().data());
  if (mpz_sgn(n) == 0) return 0;
  if (is_short_dyadic(q)) return std::ldexp(mpz_get_d(n), 1 - static_cast<int>(mpz_sizeinbase(d, 2)));
  if (mpz_sizeinbase(n, 2) <= 53 && mpz_sizeinbase(d, 2) <= 53)
    return in_nearest_rounding([&] { return mpz_get_d(n) / mpz_get_d(d); });
  // n/d has its leading bit at 2^(top-1) or 2^top; 2^shift is the last place of 55 or 56 bits of it, or a
  // quarter of the last place of a subnormal number.
  const long bits_of_n = static_cast<long>(mpz_sizeinbase(n, 2));
  const long bits_of_d = static_cast<long>(mpz_sizeinbase(d, 2));
  const long top = bits_of_n - bits_of_d;
  const bool is_dyadic = static_cast<long>(mpz_scan1(d, 0)) == bits_of_d - 1;
  if (is_dyadic && bits_of_n > 64 && std::labs(top) < 1000)
    return rounded_double(leading_bits(n), top - 63, q.sign() < 0);
  if (top > 1100) return q.sign() * std::numeric_limits<double>::infinity();
  const long shift = std::max(top - 55, -1074L - 2);
  Integer quotient;
  Integer scaled;
  const mpz_ptr a = quotient.backend().data();
  const mpz_ptr b = scaled.backend().data();
  mpz_abs(a, n);
  if (shift < 0) {
    mpz_mul_2exp(a, a, static_cast<unsigned long>(-shift));
  } else {
    mpz_mul_2exp(b, d, static_cast<unsigned long>(shift));
    d = b;
  }
  mpz_tdiv_qr(a, b, a, d);
  // Sticky bit: a nonzero remainder keeps a tie from looking exact.
  const std::uint64_t bits = mpz_get_ui(a) | static_cast<std::uint64_t>(mpz_sgn(b) != 0);
  return rounded_double(bits, shift, q.sign() < 0);
}

Rational from_double(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t biased = bits >> 52 & 0x7ff;
  if (biased == 0x7ff) throw std::invalid_argument("from_double: the number is not finite");
  std::uint64_t mantissa = bits & ((1ULL << 52) - 1);
  if (biased != 0) mantissa |= 1ULL << 52;
  if (mantissa == 0) return 0;
  const int zeros = std::countr_zero(mantissa);
  const long exponent = static_cast<long>(std::max<std::uint64_t>(biased, 1)) - 1075 + zeros;
  Rational result;
  mpq_t& q = result.backend().data();  // in lowest terms: the numerator is odd or the denominator 1
  mpz_set_ui(mpq_numref(q), mantissa >> zeros);
  const mpz_ptr part = exponent < 0 ? mpq_denref(q) : mpq_numref(q);
  mpz_mul_2exp(part, part, static_cast<mp_bitcnt_t>(std::labs(exponent)));
  if (bits >> 63 != 0) mpq_neg(q, q);
  return result;
}

Rational simplest_between(const Rational& a, const Rational& b) {
  if (a >= b) throw std::invalid_argument("simplest_between: a < b is required");
  if (a < 0 && b > 0) return 0;
  if (b <= 0) return -simplest_between(-b, -a);
  return simplest_between_positive(a, b);
}

std::optional<Rational> rational_root(const Rational& q, unsigned n) {
  if (q < 0 && n % 2 == 0) return std::nullopt;
  Integer above, below;
  // In lowest terms numerator and denominator are powers both, or q is none.
  if (mpz_root(above.backend().data(), numerator(q).backend().data(), n) == 0 ||
      mpz_root(below.backend().data(), denominator(q).backend().data(), n) == 0) {
    return std::nullopt;
  }
  return Rational(above, below);
}

Rational power_of_two(long exponent) {
  Rational power = 1;
  mpq_t& q = power.backend().data();
  const mpz_ptr part = exponent < 0 ? mpq_denref(q) : mpq_numref(q);
  mpz_mul_2exp(part, part, static_cast<mp_bitcnt_t>(std::labs(exponent)));
  return power;
}

}  // namespace exsect
