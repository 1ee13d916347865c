// Points near a crossing where traces start and end. Internal to solver/; docs/method-doubles.md,
// sections 14.9, 14.16 and 14.18.
#pragma once

#include "filter/double_point.h"

namespace exsect::filter {

/// Unless it is a crossing on sides, true. Then true only if its region meets no other sides, and no arc
/// meets these sides in it but in the centre. It has no ports yet.
template <class K>
bool leaves_sides(const PairOf<K>& pair, const DoublePointOf<K>& point);

/// Adds one port for each arc of a crossing that is inside the domain, none otherwise, `tolerance` for
/// Port::chord; false if they are not found, for example because a parameter turns in the centre.
template <class K>
bool add_ports(const PairOf<K>& pair, DoublePointOf<K>& point, double tolerance);

}  // namespace exsect::filter
