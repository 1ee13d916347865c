#include "filter/filtered_intersection.h"

#include <cmath>

#include "known_curve.h"

namespace exsect::filtered_intersection_test {
namespace {

using filter::Biquadratic;
using testing::q;

filter::Filtered solved(const testing::HeightCoefficients& h, bool with_stations) {
  return filter::filtered_intersection<Biquadratic>(testing::graph_patch(h), testing::larger_plane(), Run(),
                                                    with_stations);
}

}  // namespace

TEST_CASE("filtered intersection: decided, with what the curves do for each sweep", "[filter]") {
  const filter::Filtered circle = solved(testing::kCircle, true);
  REQUIRE(circle.result);
  CHECK(circle.result->graph.components.size() == 1);
  CHECK_FALSE(circle.stuck);
  for (const std::vector<Stations>& sweep : circle.stations) {
    REQUIRE(sweep.size() == 1);
    CHECK(sweep[0].at.size() == 2);  // the circle's two turning points with respect to each parameter
  }
  const filter::Filtered without = solved(testing::kCircle, false);
  REQUIRE(without.result);
  for (const std::vector<Stations>& sweep : without.stations) CHECK(sweep.empty());
}

TEST_CASE("filtered intersection: undecided, with the place where it ended", "[filter]") {
  // (a - b)^2 (1 + a) - a^3 has a cusp in the middle, which doubles do not decide.
  const testing::Terms a = {{{1, 0}, 1}, {{0, 0}, q(-1, 2)}}, b = {{{0, 1}, 1}, {{0, 0}, q(-1, 2)}};
  const BezierPatch x = testing::graph(a * a + testing::Terms{{{0, 0}, -2}} * a * b + b * b +
                                       testing::Terms{{{0, 0}, -1}} * a * a * b);
  const filter::Filtered cusp =
      filter::filtered_intersection<Biquadratic>(x, testing::larger_plane(), Run(), false);
  CHECK_FALSE(cusp.result);
  REQUIRE(cusp.stuck);
  for (const double w : *cusp.stuck) CHECK(std::fabs(w) < 0.05);
}

}  // namespace exsect::filtered_intersection_test
