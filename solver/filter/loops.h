// Closed curves of the intersection, by subdivision of the whole domain. Internal to solver/;
// docs/method-doubles.md, section 14.4.
#pragma once

#include <vector>

#include "filter/double_point.h"
#include "filter/trace.h"

namespace exsect::filter {

/// Appends to `traces`, which hold every curve with boundary points or ports, all closed curves inside the
/// domain. True only if these, the contacts and the double points are now the whole intersection, no curve
/// meets a contact, and no other point of a curve is singular. If not, `stuck` is where the search failed.
template <class K>
bool add_loops(const PairOf<K>& pair, const ContactsOf<K>& contacts,
               const std::vector<DoublePointOf<K>>& double_points, TreesOf<K>& trees,
               const std::vector<BoundaryPointOf<K>>& points, std::vector<TraceOf<K>>& traces, long& boxes,
               Vec4& stuck);

}  // namespace exsect::filter
