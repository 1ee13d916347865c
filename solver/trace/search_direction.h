// The direction in which searches for closed curves look for extreme points. Internal to solver/.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace exsect {

/// The direction c for which c.d keeps clearest away from zero for all d, the tangents of the curves known so
/// far: any c is legal, a good one leaves fewer boxes.
inline std::array<double, 2> search_direction(const std::vector<std::array<double, 2>>& tangents) {
  std::array<double, 2> best = {1, 0.375};
  double best_value = -1;
  for (int i = 0; i < 16; ++i) {
    const std::array<double, 2> c = {std::cos(0.19 * i), std::sin(0.19 * i)};
    double least = 1;
    for (const auto& [du, dv] : tangents)
      least = std::min(least, std::fabs(c[0] * du + c[1] * dv) / std::max(1e-300, std::hypot(du, dv)));
    if (least > best_value) {
      best_value = least;
      best = c;
    }
  }
  return best;
}

}  // namespace exsect
