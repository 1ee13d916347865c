// Rationals rounded to few bits in a known direction. Internal to solver/.
#pragma once

#include <exsect/algebra/rational.h>

namespace exsect {

/// The least n 2^k >= q and the greatest n 2^k <= q with |n| <= 2^bits, k as small as that allows up to one
/// unit; 0 for 0.
Rational rounded_up(const Rational& q, int bits = 40);
Rational rounded_down(const Rational& q, int bits = 40);

/// All quotients of numbers of both intervals, w > 0; rounded outwards to 200 bits.
RationalInterval quotients(const RationalInterval& x, const RationalInterval& w);

/// A short rational not below, not above sqrt(q), relative error below 2^-38; requires q >= 0, else
/// std::domain_error.
Rational root_above(const Rational& q);
Rational root_below(const Rational& q);

}  // namespace exsect
