// The constants that make bounds computed in doubles true. Those of the number types stand with their proofs
// in these (ball.h, double_double_ball.h, wide_ball.h), those of the solution in doubles in
// solver/filter/error_bounds.h; docs/method-doubles.md, section 14.1.
#pragma once

#include <exsect/algebra/floating_point.h>

#include <cmath>
#include <limits>

namespace exsect {

/// u, of one operation, relative to its result, if that is not subnormal.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// Makes a computed sum of fewer than 1000 nonnegative terms, each a product, quotient or square root of at
/// most 64 factors, an upper bound: they lose less than (1 - u)^1100 > 1 - 2^-42. What is lost by underflow
/// stands apart.
inline constexpr double kSlack = 1 + 0x1p-40;
/// The same for lower bounds.
inline constexpr double kReduced = 1 - 0x1p-40;
static_assert((1 - 1100 * kUnitRoundoff) * kSlack > 1 && (1 + 1200 * kUnitRoundoff) * kReduced < 1);

/// More than 1000 products and quotients lose by underflow, 2^-1075 each, also if what they lose is
/// multiplied by 2^64 afterwards.
inline constexpr double kUnderflowLoss = 0x1p-1000;
static_assert(kUnderflowLoss > 1000 * 0x1p64 * std::numeric_limits<double>::denorm_min());

/// The greatest; NaN, which no comparison accepts, if one of them is.
constexpr double larger_bound(double a, double b) {
  return b <= a || a != a ? a : b;  // written for NaN
}
template <class... More>
constexpr double larger_bound(double a, double b, More... more) {
  return larger_bound(larger_bound(a, b), more...);
}

/// At least the length of (a,b,c), but for 2^-1072 where that is subnormal; NaN or infinite if one of them
/// is.
inline double length_bound(double a, double b, double c) { return std::hypot(a, std::hypot(b, c)) * kSlack; }

}  // namespace exsect
