// No pairs of one point of space in a small rectangle near a fold, in doubles. Internal to solver/;
// docs/method-doubles.md, section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>

#include "trace/pair_system.h"

namespace exsect {

/// True only if the patch, over the unit square, has one point of space at no pair of different parameters
/// with midpoint in these ranges, (14.66). `origin`: near the patch.
bool has_no_pairs(const RationalPatch& patch, const Point& origin,
                  const std::array<DoubleBall, 2>& midpoints);

}  // namespace exsect
