// Where a search in a chart of pairs was left undecided. Internal to solver/.
#pragma once

#include <vector>

#include "self/chart.h"
#include "self/search.h"

namespace exsect {

/// Boxes of (u1,v1,u2,v2) that hold all pairs of the boxes of the chart: rounded outward, few.
std::vector<ParameterBox> undecided_places(Chart chart, const std::vector<ChartBox>& boxes);

}  // namespace exsect
