// Lists and sets of intervals against brute force over a grid.
#include "verify/interval_lists.h"

#include <algorithm>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::interval_lists_test {
namespace {

constexpr int cells = 40;

Interval random_interval(random_pairs::Generator& generator, int longest) {
  const long from = random_pairs::integer(generator, 0, cells);
  const long to = std::min<long>(cells, from + random_pairs::integer(generator, 0, longest));
  return {static_cast<double>(from), static_cast<double>(to)};
}
/// The middle of each cell, and each end: whether it is in some interval.
bool is_in(const std::vector<Interval>& all, double at) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Interval& i) { return i.first <= at && at <= i.second; });
}

}  // namespace

TEST_CASE("a set of intervals is their union, and keeps them apart") {
  random_pairs::Generator generator(51);
  INFO("seed 51");
  for (int round = 0; round < 300; ++round) {
    IntervalSet set;
    std::vector<Interval> all;
    for (int i = 0; i < 12; ++i) {
      all.push_back(random_interval(generator, 6));
      set.add(all.back());
      REQUIRE(set.intervals() == united(all));
      for (int k = 0; k <= 2 * cells; ++k) REQUIRE(set.contains(k / 2.0) == is_in(all, k / 2.0));
      const Interval part = random_interval(generator, cells);
      double length = 0;
      for (double at = part.first + 0.5; at < part.second; ++at) length += is_in(all, at) ? 1 : 0;
      REQUIRE(set.length(part.first, part.second) == length);
    }
  }
}

TEST_CASE("what two lists of intervals have in common") {
  random_pairs::Generator generator(52);
  INFO("seed 52");
  for (int round = 0; round < 300; ++round) {
    std::array<std::vector<Interval>, 2> lists;
    for (auto& list : lists) {
      for (int i = 0; i < 8; ++i) list.push_back(random_interval(generator, 6));
      list = united(list);
    }
    const std::vector<Interval> both = common(lists[0], lists[1]);
    for (int k = 0; k <= 2 * cells; ++k)
      REQUIRE(is_in(both, k / 2.0) == (is_in(lists[0], k / 2.0) && is_in(lists[1], k / 2.0)));
  }
}

TEST_CASE("an index of intervals finds those that have a part in common with another one") {
  random_pairs::Generator generator(53);
  INFO("seed 53");
  for (int round = 0; round < 300; ++round) {
    IntervalIndex index;
    std::vector<Interval> all;
    for (int i = 0; i < 20; ++i) {
      all.push_back(random_interval(generator, round % 3 == 0 ? cells : 4));
      index.add(all.back());
    }
    const Interval other = random_interval(generator, 8);
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].first < other.second && all[i].second > other.first) expected.push_back(i);
    REQUIRE(index.crossing(other) == expected);
  }
}

}  // namespace exsect::interval_lists_test
