#include "sweep/sweep_data.h"

#include <algorithm>

#include "line/line_points_in.h"

namespace exsect {

bool in_star(const SweepData& sweep, const CertifiedPoint& point) {
  return std::any_of(sweep.stars.begin(), sweep.stars.end(),
                     [&](const StarNeighbourhood& star) { return surely_lies_in(point, star.box); });
}

}  // namespace exsect
