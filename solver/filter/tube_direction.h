// Enclosures of the direction of a tube's arc. Internal to solver/; docs/method-doubles.md, section 14.2.
#pragma once

#include "filter/tube.h"

namespace exsect::filter {

/// w'(tau) is within `radius` of `middle`.
template <class K>
struct Direction {
  Unknowns<K> middle;
  double radius;
};
/// By (14.9), after `bound_derivatives` and `expand_arc`.
template <class K>
Direction<K> direction_at(const TubeOf<K>& tube, double tau);

}  // namespace exsect::filter
