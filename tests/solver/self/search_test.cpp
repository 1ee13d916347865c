#include "self/search.h"

#include <random>

#include "support/catch.h"
#include "support/self_checks.h"

namespace exsect::search_test {
using exsect::testing::random_patch;

TEST_CASE("chart search: the direction is in terms of u and v in both charts") {
  const Point origin = {0, 0, 0};
  const auto nothing_known = [](const BallPoint<DoubleBall>&) { return false; };
  std::mt19937 generator(7);
  int depends_on_direction = 0;
  for (int i = 0; i < 12; ++i) {
    INFO("seed 7, patch " << i);
    const BezierPatch x = random_patch(generator, 3);
    const ChartSystem<DoubleBall> second(x, origin, 2, Chart::second);
    const ChartSystem<DoubleBall> of_exchanged(x.exchanged(), origin, 2, Chart::first);
    const auto search = [&](const ChartSystem<DoubleBall>& chart, const std::array<double, 2>& direction) {
      return search_chart<DoubleBall>(chart, KnownPlaces({}), {whole_chart}, direction, nothing_known, 600,
                                      {});
    };
    const SearchOutcome a = search(second, {1, 0.375});
    const SearchOutcome b = search(of_exchanged, {0.375, 1});
    // The two systems are the same, of the same patch with the parameters exchanged.
    CHECK(a.boxes == b.boxes);
    CHECK(a.undecided.size() == b.undecided.size());
    const SearchOutcome other = search(of_exchanged, {1, 0.375});
    if (other.boxes != b.boxes || other.undecided.size() != b.undecided.size()) ++depends_on_direction;
  }
  CHECK(depends_on_direction > 0);
}

}  // namespace exsect::search_test
