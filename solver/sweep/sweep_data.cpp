#include "sweep/sweep_data.h"

#include <algorithm>

#include "answer/parameter_box.h"

namespace exsect {

bool in_star(const SweepData& sweep, const CertifiedPoint& point) {
  return std::any_of(sweep.stars.begin(), sweep.stars.end(), [&](const StarNeighbourhood& star) {
    return lies_in(point.refined_to(power_of_two(-100)).box(), star.box);
  });
}

}  // namespace exsect
