// Closed curves of the intersection, by subdivision of the whole domain. Internal to solver/; docs/method.md,
// section 14.4.
#pragma once

#include <vector>

#include "filter_trace.h"

namespace exsect::filter {

/// Appends to `traces`, which hold every curve with boundary points, all closed curves inside the domain.
/// True only if these are now all curves of the intersection and it has no singular points.
bool add_loops(const Pair& pair, Trees& trees, const std::vector<BoundaryPoint>& points,
               std::vector<Trace>& traces, long& boxes);

}  // namespace exsect::filter
