// The constants of bounds in doubles. Internal to verify/; docs/method.md, section 15.
#pragma once

#include <limits>

namespace exsect {

/// A distance that is not known.
inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// Of one operation, relative to its result.
inline constexpr double unit_roundoff = 0x1p-53;
/// Makes a number that is the result of at most 1000 operations on nonnegative numbers an upper bound.
inline constexpr double upwards = 1 + 0x1p-40;
/// More than the operations of one evaluation lose by underflow.
inline constexpr double underflow = 0x1p-1000;

}  // namespace exsect
