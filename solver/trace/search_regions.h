// Regions that a search by subdivision leaves over. Internal to solver/.
#pragma once

#include "trace/subdivision.h"

namespace exsect {

/// The bounding regions of the connected groups of touching regions; if these are many, the regions are first
/// rounded outwards to a grid.
std::vector<SearchRegion> merged(std::vector<SearchRegion> regions);

}  // namespace exsect
