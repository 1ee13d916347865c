#include "self/chart_directions.h"

#include <set>

#include "support/catch.h"

namespace exsect::chart_directions_test {

namespace {

using Direction = std::array<double, 2>;

const BoxesByChart kBothCharts = {{{whole_chart}, {whole_chart}}};
const Direction kC = {1, 0.375};

/// Decides a chart along the directions with these numbers, counted in the order in which they are first
/// asked for; boxes are left in all other cases.
class StubSearch {
 public:
  explicit StubSearch(std::array<std::set<std::size_t>, 2> decided) : decided_(std::move(decided)) {}

  std::vector<ChartBox> operator()(Chart chart, const Direction& c, const std::vector<ChartBox>& boxes) {
    if (boxes.empty()) return {};
    const auto at = std::ranges::find(directions_, c);
    const auto number = static_cast<std::size_t>(at - directions_.begin());
    if (at == directions_.end()) directions_.push_back(c);
    return decided_[chart == Chart::first ? 0 : 1].contains(number) ? std::vector<ChartBox>{} : boxes;
  }
  std::size_t directions() const { return directions_.size(); }

 private:
  std::array<std::set<std::size_t>, 2> decided_;
  std::vector<Direction> directions_;
};

}  // namespace

TEST_CASE("chart directions: charts decided along different directions are not decided together") {
  StubSearch search({{{0}, {1, 2}}});
  const BoxesByChart left = searched_along_one_direction(kC, kBothCharts, std::ref(search), {});
  CHECK(left[0].empty());
  CHECK(left[1].size() == 1);
  CHECK_FALSE(is_decided(left));
  CHECK(search.directions() == 3);
}

TEST_CASE("chart directions: one direction for both charts decides, whichever it is") {
  for (const std::size_t number : {0, 1, 2}) {
    INFO("direction " << number);
    StubSearch search({{{number}, {0, number}}});
    CHECK(is_decided(searched_along_one_direction(kC, kBothCharts, std::ref(search), {})));
    CHECK(search.directions() == number + 1);
  }
}

TEST_CASE("chart directions: what an earlier search has decided counts along its own direction alone") {
  const BoxesByChart second_left = {{{}, {whole_chart}}};
  StubSearch own({{{}, {0}}});
  CHECK(is_decided(searched_along_one_direction(kC, second_left, std::ref(own), {})));
  StubSearch other({{{}, {1}}});
  CHECK_FALSE(is_decided(searched_along_one_direction(kC, second_left, std::ref(other), {})));
}

TEST_CASE("chart directions: the three directions are far from each other, a stop ends the search") {
  std::vector<Direction> asked;
  const auto record = [&](Chart, const Direction& c, const std::vector<ChartBox>& boxes) {
    asked.push_back(c);
    return boxes;
  };
  const BoxesByChart left = searched_along_one_direction(kC, kBothCharts, record, {});
  CHECK(left[0].size() + left[1].size() == 2);
  REQUIRE(asked.size() == 4);  // a turned direction ends with the first chart that it leaves open
  for (const Direction& other : {asked[2], asked[3]})
    CHECK(std::fabs(kC[0] * other[1] - kC[1] * other[0]) > 0.5 * std::hypot(kC[0], kC[1]));
  asked.clear();
  searched_along_one_direction(kC, kBothCharts, record, [] { return true; });
  CHECK(asked.size() == 2);
}

}  // namespace exsect::chart_directions_test
