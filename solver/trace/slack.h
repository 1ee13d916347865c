// The factor that covers the rounding of bounds in doubles. Internal to solver/.
#pragma once

namespace exsect {

/// Makes a computed sum of fewer than 1000 nonnegative terms, each a product of at most 64 factors, an upper
/// bound: they lose less than (1 - 2^-53)^1100 > 1 - 2^-42. What is lost by underflow stands apart.
inline constexpr double kSlack = 1 + 0x1p-40;

}  // namespace exsect
