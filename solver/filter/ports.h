// Points near a crossing where traces start and end. Internal to solver/; docs/method.md, sections 14.9
// and 14.16.
#pragma once

#include "filter/double_point.h"

namespace exsect::filter {

/// Adds one port for each arc of a crossing, none otherwise, `tolerance` for Port::chord; false if they are
/// not found, for example because a parameter turns in the centre.
template <class K>
bool add_ports(const PairOf<K>& pair, DoublePointOf<K>& point, double tolerance);

}  // namespace exsect::filter
