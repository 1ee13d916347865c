#include "curve/short_rational.h"

#include <algorithm>
#include <stdexcept>

namespace exsect {
namespace {

long bit_length(const Integer& n) { return n == 0 ? 0 : static_cast<long>(msb(abs(n))) + 1; }

/// Floor of the logarithm to base 2 of |q| != 0, or one more.
long magnitude(const Rational& q) { return bit_length(numerator(q)) - bit_length(denominator(q)); }

Integer floor(const Rational& q) {
  Integer result;
  mpz_fdiv_q(result.backend().data(), numerator(q).backend().data(), denominator(q).backend().data());
  return result;
}

}  // namespace

Rational rounded_down(const Rational& q, int bits) {
  if (q == 0) return 0;
  const Rational unit = power_of_two(magnitude(q) + 1 - bits);
  return floor(q / unit) * unit;
}

Rational rounded_up(const Rational& q, int bits) { return -rounded_down(-q, bits); }

RationalInterval quotients(const RationalInterval& x, const RationalInterval& w) {
  constexpr int bits = 200;
  return {rounded_down(std::min<Rational>(x.lower / w.lower, x.lower / w.upper), bits),
          rounded_up(std::max<Rational>(x.upper / w.lower, x.upper / w.upper), bits)};
}

Rational root_below(const Rational& q) {
  if (q < 0) throw std::domain_error("square root of a negative number");
  if (q == 0) return 0;
  // sqrt(q) = sqrt(q 4^k) 2^-k with q 4^k of 80 bits or more.
  const long k = 41 - (magnitude(q) - (magnitude(q) & 1)) / 2;
  return Rational(sqrt(floor(q * power_of_two(2 * k)))) * power_of_two(-k);
}

Rational root_above(const Rational& q) {
  if (q == 0) return 0;
  const long k = 41 - (magnitude(q) - (magnitude(q) & 1)) / 2;
  return root_below(q) + power_of_two(-k);
}

}  // namespace exsect
