// Ports on the branches that end in a common corner. Internal to solver/; docs/method-doubles.md, section
// 14.26.
#pragma once

#include <optional>

#include "filter/corner_branches.h"
#include "filter/double_point.h"

namespace exsect::filter {

/// The corner, one port for each of the branches; empty if one is not found. `x` is what the branches were
/// found of.
template <class K>
std::optional<CentreOf<K>> branched_corner(const PairOf<K>& pair, const CornerContact& corner,
                                           const CornerNet& x, const CornerBranches& found);

}  // namespace exsect::filter
