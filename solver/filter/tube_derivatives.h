// First and second derivatives along the arc of a tube. Internal to solver/; docs/method-doubles.md,
// section 14.2.
#pragma once

#include "filter/tube.h"

namespace exsect::filter {

/// Bounds slope_error, second and second_error, and what is further; requires a tube that is certified.
template <class K>
void bound_derivatives(const PairOf<K>& pair, TubeOf<K>& tube);

}  // namespace exsect::filter
