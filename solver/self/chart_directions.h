// In which direction both charts of pairs are searched for closed curves. Internal to solver/;
// docs/method.md, section 7.3.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "answer/stop_request.h"
#include "self/chart.h"
#include "self/known_places.h"

namespace exsect {

/// Boxes of the chart `first` and of the chart `second`.
using BoxesByChart = std::array<std::vector<ChartBox>, 2>;

inline bool is_decided(const BoxesByChart& left) {
  return std::ranges::all_of(left, [](const std::vector<ChartBox>& boxes) { return boxes.empty(); });
}

/// What is left of both charts by searches along c, and if something is, by searches of all of both charts
/// along two other directions. The direction is the same for both charts: a closed curve that runs through
/// both has the greatest value of c . (U,V) in one of them, and a search along another direction there would
/// not look for it. `search(chart, c, boxes)`, c in terms of u and v, returns which boxes it leaves undecided
/// of those given; `left` is what an earlier search along c has left. Nothing is left if one of the
/// directions decides both charts; otherwise it is what c leaves.
template <class Search>
BoxesByChart searched_along_one_direction(const std::array<double, 2>& c, const BoxesByChart& left,
                                          const Search& search, const StopRequest& stop) {
  const BoxesByChart undecided = {search(Chart::first, c, left[0]), search(Chart::second, c, left[1])};
  for (const double turned : {1.0, 2.0}) {
    if (is_decided(undecided) || is_stopped(stop)) break;
    const double angle = turned * std::numbers::pi / 3;
    const std::array<double, 2> other = {std::cos(angle) * c[0] - std::sin(angle) * c[1],
                                         std::sin(angle) * c[0] + std::cos(angle) * c[1]};
    const bool decides = std::ranges::all_of(std::array{Chart::first, Chart::second}, [&](Chart chart) {
      return search(chart, other, std::vector<ChartBox>{whole_chart}).empty();
    });
    if (decides) return {};
  }
  return undecided;
}

}  // namespace exsect
