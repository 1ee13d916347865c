#include "trace/search_regions.h"

#include <algorithm>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::search_regions_test {
namespace {

bool touch(const SearchRegion& a, const SearchRegion& b) {
  for (std::size_t j = 0; j < 4; ++j)
    if (a.upper[j] < b.lower[j] || b.upper[j] < a.lower[j]) return false;
  return true;
}

bool covers(const SearchRegion& a, const SearchRegion& b) {
  for (std::size_t j = 0; j < 4; ++j)
    if (b.lower[j] < a.lower[j] || a.upper[j] < b.upper[j]) return false;
  return true;
}

/// Hulls of regions that touch, again and again until none do: the order does not matter.
std::vector<SearchRegion> merged_pair_by_pair(std::vector<SearchRegion> regions) {
  for (std::size_t i = 0; i < regions.size(); ++i)
    for (std::size_t j = i + 1; j < regions.size(); ++j)
      if (touch(regions[i], regions[j])) {
        for (std::size_t k = 0; k < 4; ++k) {
          regions[i].lower[k] = std::min(regions[i].lower[k], regions[j].lower[k]);
          regions[i].upper[k] = std::max(regions[i].upper[k], regions[j].upper[k]);
        }
        regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(j));
        return merged_pair_by_pair(std::move(regions));
      }
  return regions;
}

std::vector<SearchRegion> random_regions(random_pairs::Generator& generator, int count, long cells) {
  std::vector<SearchRegion> regions;
  for (int i = 0; i < count; ++i) {
    SearchRegion region{};
    for (std::size_t j = 0; j < 4; ++j) {
      const auto at = static_cast<double>(random_pairs::integer(generator, 0, cells - 1));
      region.lower[j] = at / static_cast<double>(cells);
      region.upper[j] = (at + 1) / static_cast<double>(cells);
    }
    regions.push_back(region);
  }
  return regions;
}

}  // namespace

TEST_CASE("search regions: groups cover, and hold together", "[trace]") {
  random_pairs::Generator generator(20263);
  CHECK(merged({}).empty());
  const SearchRegion first = {{0, 0, 0, 0}, {0.25, 0.25, 0.25, 0.25}};
  const SearchRegion corner = {{0.25, 0.25, 0.25, 0.25}, {0.5, 0.5, 0.5, 0.5}};
  const SearchRegion far = {{0.75, 0, 0, 0}, {1, 1, 1, 1}};
  const auto three = merged({first, far, corner});
  REQUIRE(three.size() == 2);
  const std::size_t two = three[0].lower[0] == 0 ? 0 : 1;
  CHECK(three[two].lower == first.lower);
  CHECK(three[two].upper == corner.upper);
  CHECK(three[1 - two].lower == far.lower);
  for (const long cells : {2L, 4L, 8L, 16L}) {
    for (int round = 0; round < 10; ++round) {
      const auto regions = random_regions(generator, 24, cells);
      const auto groups = merged(regions);
      const auto whole = merged_pair_by_pair(regions);
      // Each region is in a group, and each group in what hangs together when groups are merged on and on.
      for (const SearchRegion& region : regions)
        CHECK(std::any_of(groups.begin(), groups.end(),
                          [&](const SearchRegion& group) { return covers(group, region); }));
      for (const SearchRegion& group : groups)
        CHECK(std::any_of(whole.begin(), whole.end(),
                          [&](const SearchRegion& all) { return covers(all, group); }));
      CHECK(groups.size() >= whole.size());
    }
  }
}

TEST_CASE("search regions: thousands are covered by few", "[trace]") {
  random_pairs::Generator generator(20264);
  const auto regions = random_regions(generator, 3000, 1L << 14);
  const auto groups = merged(regions);
  CHECK(groups.size() <= 500);
  for (const SearchRegion& region : regions)
    CHECK(std::count_if(groups.begin(), groups.end(),
                        [&](const SearchRegion& group) { return covers(group, region); }) >= 1);
}

}  // namespace exsect::search_regions_test
