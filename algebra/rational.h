// Exact numbers at the interface: GMP integers and rationals through Boost.Multiprecision.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <optional>

namespace exsect {

/// Expression templates are off: `auto` then means a number.
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// Invariant: lower <= upper. Whether the ends belong to it is said where it is used.
struct RationalInterval {
  Rational lower;
  Rational upper;

  Rational width() const { return upper - lower; }
  Rational midpoint() const { return (lower + upper) / 2; }
};

/// -1, 0, +1.
int sign(const Rational& q);

/// The double nearest to q (ties to even); infinite beyond the range of doubles.
double to_double(const Rational& q);
/// An integer of at most 53 bits over 2^k, k < 1000: to_double() is q itself, and quick.
bool is_short_dyadic(const Rational& q);

/// The rational that the finite double x is, exactly. Throws std::invalid_argument for NaN and infinities.
Rational from_double(double x);

/// The rational of least denominator in the open interval (a,b); requires a < b, else std::invalid_argument.
Rational simplest_between(const Rational& a, const Rational& b);

/// The rational number r with r^n = q, the one that is not negative if n is even; empty if there is none.
/// Requires n >= 1.
std::optional<Rational> rational_root(const Rational& q, unsigned n);

/// 2^exponent, any sign of the exponent.
Rational power_of_two(long exponent);

}  // namespace exsect
