// Distances that are not known. Internal to verify/.
#pragma once

#include <limits>

namespace exsect {

/// A distance that is not known.
inline constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace exsect
