#include "filter/filtered_intersection.h"

#include <cmath>

#include "known_curve.h"
#include "support/power_nets.h"

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

TEST_CASE("filtered intersection: from corner to corner, along three sides to higher order", "[filter]") {
  using filter::Bicubic;
  // (u, v, 0) and (r, r^2 s, s - r^3): v = u^5, r = u, s = u^3.
  const testing::Terms r = {{{1, 0}, 1}};
  const auto x = filter::elevated<Bicubic>(testing::plane_patch());
  const auto y = filter::elevated<Bicubic>(
      testing::power_patch({r, testing::Terms{{{2, 1}, 1}}, testing::Terms{{{0, 1}, 1}, {{3, 0}, -1}}}, 3));
  const filter::Filtered curve = filter::filtered_intersection<Bicubic>(x, y, Run(), false);
  REQUIRE(curve.result);
  const IntersectionGraph& graph = curve.result->graph;
  REQUIRE(graph.arcs.size() == 1);  // no turning point
  CHECK(graph.nodes.size() == 2);
}

}  // namespace exsect::filtered_intersection_test
