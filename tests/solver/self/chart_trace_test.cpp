#include "self/chart_trace.h"

#include "answer/model_scale.h"
#include "self/chart_turning.h"
#include "self/curves.h"
#include "self/near_cusps.h"
#include "shape/coincident_parameters.h"
#include "support/catch.h"
#include "support/self_checks.h"

namespace exsect::chart_trace_test {

namespace {

// A curve from a cuspidal point that is long in the charts: it ends in a cuspidal corner.
const std::vector<int> kToCuspidalCorner = {-1, 0, -1, 1, 1, 0,  0, 0, 1,  1,  1,  0,  0, 1,
                                            1,  0, -1, 1, 0, -1, 0, 1, -1, -1, -1, -1, -1};

}  // namespace

TEST_CASE("charts: a trace from a cuspidal point stops when it must") {
  const BezierPatch x = exsect::testing::patch(kToCuspidalCorner);
  const ModelScale scale = model_scale(x, x);
  const SelfSystem<DoubleBall> system(x, scale.origin, scale.frame.exponent);
  ExactPlaces exact{};
  exact.cusps = special_cusps(x);
  exact.coincident = coincident_parameters(x, x);
  SelfCurves<DoubleBall> found;
  add_near_cusps(found, system, exact, KnownPlaces({}), power_of_two(-50), {});
  REQUIRE_FALSE(found.cusps.empty());
  const StopRequest at_once = [] { return true; };
  const auto from = [&](std::size_t k, const StopRequest& stop) {
    return trace_from_cusp(system.charts, found.cusps, static_cast<int>(k), stop);
  };
  std::size_t longest = 0;
  for (std::size_t k = 1; k < found.cusps.size(); ++k)
    if (from(k, {}).pieces.size() > from(longest, {}).pieces.size()) longest = k;
  auto trace = from(longest, {});
  REQUIRE(trace.pieces.size() > 10);
  CHECK(from(longest, at_once).pieces.size() == 1);
  const auto stopped = find_chart_turning_points(system.charts, trace, exact.coincident, at_once);
  REQUIRE(stopped);
  CHECK(std::string(stopped->why).find("work cap") != std::string::npos);
  CHECK_FALSE(find_chart_turning_points(system.charts, trace, exact.coincident, {}));
}

}  // namespace exsect::chart_trace_test
