// Where a patch of any kind meets itself, in doubles. Internal to solver/; docs/method-doubles.md,
// section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include "answer/run.h"

namespace exsect {

/// As self_intersect(); where doubles do not decide, an incomplete result says where the search ended.
IntersectResult self_intersect_in_doubles(const RationalPatch& x, const Run& run);

}  // namespace exsect
