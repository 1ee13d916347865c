#include "self/undecided_places.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "trace/search_regions.h"
#include "trace/subdivision.h"

namespace exsect {
namespace {

/// Places shown for undecided boxes: their coordinates are rounded outward to this grid.
constexpr double kGrid = 0x1p-4;

ParameterBox to_parameter_box(const std::array<double, 4>& lower, const std::array<double, 4>& upper) {
  ParameterBox box;
  for (std::size_t j = 0; j < 4; ++j) {
    box[j] = {from_double(std::clamp(lower[j], 0.0, 1.0)), from_double(std::clamp(upper[j], 0.0, 1.0))};
  }
  return box;
}

/// The pairs of a box of a chart in the square, rounded outward to the grid.
SearchRegion region_of(Chart chart, const ChartBox& box) {
  const SearchRegion pairs = pair_bounds(chart, box);
  SearchRegion region{};
  for (std::size_t j = 0; j < 4; ++j) {
    region.lower[j] = std::clamp(kGrid * std::floor(pairs.lower[j] / kGrid - 0x1p-20), 0.0, 1.0);
    region.upper[j] = std::clamp(kGrid * std::ceil(pairs.upper[j] / kGrid + 0x1p-20), 0.0, 1.0);
  }
  return region;
}

}  // namespace

std::vector<ParameterBox> undecided_places(Chart chart, const std::vector<ChartBox>& boxes) {
  std::set<std::pair<std::array<double, 4>, std::array<double, 4>>> regions;
  for (const ChartBox& box : boxes) {
    const SearchRegion region = region_of(chart, box);
    regions.insert({region.lower, region.upper});
  }
  std::vector<SearchRegion> distinct;
  for (const auto& [lower, upper] : regions) {
    distinct.push_back({lower, upper});
  }
  std::vector<ParameterBox> result;
  for (const SearchRegion& region : merged(std::move(distinct))) {
    result.push_back(to_parameter_box(region.lower, region.upper));
  }
  return result;
}

}  // namespace exsect
