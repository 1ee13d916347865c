#include "filter/known_pair.h"

#include "known_curve.h"

namespace exsect::known_pair_test {
namespace {

using testing::KnownCurve;

filter::KnownPair<filter::Biquadratic> known_hyperbola() {
  const KnownCurve curve(testing::kHyperbola);
  return {{}, curve.pair, {}, {}, curve.points, {}, {{curve.arc(), {}}}, {0, 1, 0, 1}, false};
}

Run run_to(double tolerance) {
  IntersectOptions options;
  options.tolerance = tolerance;
  options.turning = {};
  return Run(options);
}

}  // namespace

TEST_CASE("known pair: drawn at any tolerance, the same nodes and the same arc", "[filter]") {
  const auto known = known_hyperbola();
  const double extent = known.pair.extent;
  std::size_t vertices = 0;
  for (const double tolerance : {1e-2, 1e-5, 1e-8}) {
    const auto result = filter::drawn(known, run_to(tolerance));
    REQUIRE(result);
    CHECK(result->status == Status::complete);
    CHECK(result->graph.nodes.size() == 2);
    REQUIRE(result->graph.arcs.size() == 1);
    REQUIRE(result->graph.components.size() == 1);
    CHECK(result->graph.components[0].shape == ComponentShape::open);
    CHECK(result->graph.arcs[0].error_bound <= tolerance * extent);
    CHECK(result->graph.arcs[0].polyline.size() > vertices);
    vertices = result->graph.arcs[0].polyline.size();
  }
}

TEST_CASE("known pair: nothing is drawn when the time is over", "[filter]") {
  IntersectOptions options;
  options.max_seconds = 1e-9;
  CHECK_FALSE(filter::drawn(known_hyperbola(), Run(options)));
}

}  // namespace exsect::known_pair_test
