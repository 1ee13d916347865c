// Closed curves of the intersection, by subdivision of the whole domain. Internal to solver/; docs/method.md,
// section 14.4.
#pragma once

#include <vector>

#include "filter_trace.h"

namespace exsect::filter {

/// Appends to `traces`, which hold every curve with boundary points, all closed curves inside the domain.
/// True only if these and the contacts are now the whole intersection, no curve meets a contact, and no point
/// of a curve is singular.
bool add_loops(const Pair& pair, const Contacts& contacts, Trees& trees,
               const std::vector<BoundaryPoint>& points, std::vector<Trace>& traces, long& boxes);

}  // namespace exsect::filter
