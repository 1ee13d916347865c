#include "sweep/traced_pair.h"

#include "answer/parameter_box.h"
#include "support/families.h"
#include "support/known_curves.h"
#include "swept_pair.h"

namespace exsect::traced_pair_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

TracedPair<DoubleBall> traced_pair(const BezierPatch& x, const BezierPatch& y, SweptPair& swept) {
  const ModelScale unmoved = {{{0, 0, 0}, 0}, {0, 0, 0}, 1};
  return {x,
          y,
          unmoved,
          1e-6,
          boundary_lines(x, y, unmoved, side_tolerance(1e-6), {}),
          swept.data.landmarks,
          {},
          {},
          swept.system,
          swept.landmarks,
          trace_curves(swept.system, swept.landmarks, swept.data, swept.width, {})};
}

Run run_to(double tolerance) {
  IntersectOptions options;
  options.tolerance = tolerance;
  return Run(options);
}

}  // namespace

TEST_CASE("traced pair: drawn at any tolerance it has the same nodes and arcs", "[sweep]") {
  for (const HeightCoefficients& h : {kCircle, kHyperbola, kParabola}) {
    const BezierPatch x = graph_patch(h), y = plane_patch();
    SweptPair swept(x, y);
    const TracedPair<DoubleBall> pair = traced_pair(x, y, swept);
    std::size_t vertices = 0;
    std::optional<IntersectionGraph> first;
    for (const double tolerance : {1e-2, 1e-4, 1e-8}) {
      const auto result = drawn(pair, run_to(tolerance));
      REQUIRE(result);
      CHECK(result->incomplete.empty());
      if (!first) first = result->graph;
      CHECK(result->graph.nodes.size() == first->nodes.size());
      REQUIRE(result->graph.arcs.size() == first->arcs.size());
      std::size_t count = 0;
      for (std::size_t i = 0; i < first->arcs.size(); ++i) {
        const Arc& arc = result->graph.arcs[i];
        CHECK(arc.from == first->arcs[i].from);
        CHECK(arc.to == first->arcs[i].to);
        CHECK(arc.error_bound <= tolerance);
        count += arc.polyline.size();
      }
      CHECK(count > vertices);
      vertices = count;
    }
  }
}

TEST_CASE("traced pair: doubles are too rough for what is finer than they are", "[sweep]") {
  const BezierPatch x = graph_patch(kCircle), y = plane_patch();
  SweptPair swept(x, y);
  TracedPair<DoubleBall> pair = traced_pair(x, y, swept);
  // A problem is handed on, and ends the search for more precision.
  pair.traced.problems.push_back({whole_domain(), "a test's problem"});
  const auto result = drawn(pair, run_to(1e-3));
  REQUIRE(result);
  REQUIRE(result->incomplete.size() == 1);
  CHECK(result->incomplete[0].why == "a test's problem");
}

TEST_CASE("traced pair: arcs on sides are drawn again for their own tolerance", "[sweep]") {
  CHECK(side_tolerance(1e-3) < 1e-3);
  CHECK(side_tolerance(1e-3) > 0);
}

}  // namespace exsect::traced_pair_test
