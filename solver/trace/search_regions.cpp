#include "trace/search_regions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace exsect {

namespace {

/// The cells of a dyadic grid that hold the regions, at most `most` of them.
std::vector<SearchRegion> coarsened(const std::vector<SearchRegion>& regions, std::size_t most) {
  for (double grid = 0x1p-12;; grid *= 2) {
    std::set<std::pair<std::array<double, 4>, std::array<double, 4>>> cells;
    for (const SearchRegion& region : regions) {
      std::array<double, 4> lower{};
      std::array<double, 4> upper{};
      for (std::size_t j = 0; j < 4; ++j) {
        lower[j] = grid * std::floor(region.lower[j] / grid);
        upper[j] = grid * std::ceil(region.upper[j] / grid);
      }
      cells.emplace(lower, upper);
    }
    if (cells.size() > most) {
      continue;
    }
    std::vector<SearchRegion> result;
    for (const auto& [lower, upper] : cells) {
      result.push_back({lower, upper});
    }
    return result;
  }
}

constexpr std::size_t kMostMerged = 500;  // merging takes their number squared, or cubed

}  // namespace

std::vector<SearchRegion> merged(std::vector<SearchRegion> regions) {
  if (regions.size() > kMostMerged) {
    regions = coarsened(regions, kMostMerged);
  }
  const auto touch = [](const SearchRegion& a, const SearchRegion& b) {
    bool meets = true;
    for (std::size_t j = 0; j < 4; ++j) {
      meets = meets && a.lower[j] <= b.upper[j] && b.lower[j] <= a.upper[j];
    }
    return meets;
  };
  std::vector<SearchRegion> groups;
  while (!regions.empty()) {
    SearchRegion group = regions.back();
    regions.pop_back();
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t i = regions.size(); i-- > 0;) {
        if (touch(group, regions[i])) {
          for (std::size_t j = 0; j < 4; ++j) {
            group.lower[j] = std::min(group.lower[j], regions[i].lower[j]);
            group.upper[j] = std::max(group.upper[j], regions[i].upper[j]);
          }
          regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(i));
          grown = true;
        }
      }
    }
    groups.push_back(group);
  }
  return groups;
}

}  // namespace exsect
