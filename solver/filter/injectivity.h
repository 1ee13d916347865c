// Rectangles on which a patch is injective, in doubles. Internal to solver/; docs/method-doubles.md,
// sections 14.10 and 14.15.
#pragma once

#include "filter/mean_derivatives.h"

namespace exsect::filter {

/// True only if the patch takes no value at two different points of the rectangle, (14.24) or (14.41). Means
/// of derivatives err by less than `error` times |row|_1.
template <class K>
bool is_injective(const PatchOf<K>& patch, double error, const Rectangle& where);

}  // namespace exsect::filter
