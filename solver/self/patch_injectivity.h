// Where a patch of any kind is injective, in doubles. Internal to solver/; docs/method-doubles.md,
// section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <functional>

#include "filter/mean_derivatives.h"

namespace exsect {

/// True only if the patch takes no value at two different points of the rectangle of centred parameters,
/// which lies in the square. Empty for a patch with coordinates beyond the range of doubles.
using InjectiveRectangle = std::function<bool(const filter::Rectangle&)>;
InjectiveRectangle patch_injectivity(const RationalPatch& patch);

}  // namespace exsect
