// The roots of the turning eliminant E(u) from its values in balls of 256 bits. Internal to solver/.
#pragma once

#include <exsect/algebra/rational.h>
#include <exsect/geometry/integer_pair.h>

#include <optional>
#include <vector>

#include "eliminant/weighted_pair.h"

namespace exsect {

/// Isolating intervals of the roots of E(u) in [0,1], as by isolate_enclosed_roots: docs/method.md,
/// section 4.5. Empty where (4.8), or with weights
/// (16.9), does not define E, or 256 bits are too few. The time does not depend on the
/// length of the integers.
std::optional<std::vector<RationalInterval>> turning_roots_in_balls(const IntegerPair& pair);
std::optional<std::vector<RationalInterval>> turning_roots_in_balls(const WeightedPair& pair);

}  // namespace exsect
