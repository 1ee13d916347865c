#include "sweep/traced_curves.h"

#include <algorithm>

#include "support/known_curves.h"
#include "swept_pair.h"

namespace exsect::traced_curves_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

TracedCurves<DoubleBall> traced(SweptPair& pair) {
  return trace_curves(pair.system, pair.landmarks, pair.data, pair.width, {});
}

}  // namespace

TEST_CASE("traced curves: open and closed ones, none missing") {
  SweptPair circle(graph_patch(kCircle), plane_patch());
  const TracedCurves<DoubleBall> closed = traced(circle);
  CHECK(closed.problems.empty());
  REQUIRE(closed.curves.size() == 1);
  CHECK(closed.curves[0].trace.start == -1);
  CHECK(curves_through(closed, on_diagonal(q(7, 10), q(23, 30))) == 1);
  CHECK(curves_through(closed, on_diagonal(q(1, 2), q(1, 2))) == 0);

  SweptPair hyperbola(graph_patch(kHyperbola), plane_patch());
  const TracedCurves<DoubleBall> open = traced(hyperbola);
  CHECK(open.problems.empty());
  REQUIRE(open.curves.size() == 1);
  CHECK(open.curves[0].trace.start + open.curves[0].trace.end == 1);
  CHECK(open.curves[0].turning.empty());
  CHECK(open.isolated.empty());
  CHECK(contacts_through(open, on_diagonal(q(1, 2), q(1, 2))) == 0);
}

TEST_CASE("traced curves: a circle that touches a side is isolated there from outside") {
  // (u + 1/4)^2 + (v - 1/2)^2 = 1/16 has the one point (0, 1/2).
  const HeightCoefficients outside = {{{q(1, 4), -1, 1}, {q(1, 2), 0, 0}, {1, 0, 0}}};
  SweptPair pair(graph_patch(outside), plane_patch());
  const TracedCurves<DoubleBall> result = traced(pair);
  CHECK(result.problems.empty());
  CHECK(result.curves.empty());
  CHECK(result.isolated == std::vector<int>{0});
}

TEST_CASE("traced curves: what the fibres do not agree with is a problem") {
  SweptPair circle(graph_patch(kCircle), plane_patch());
  // A fibre that is known to have one point less: the circle meets it twice.
  auto& fibres = circle.data.fibres;
  const auto two = std::find_if(fibres.begin(), fibres.end(), [](const auto& f) { return f.size() == 2; });
  REQUIRE(two != fibres.end());
  two->pop_back();
  CHECK_FALSE(traced(circle).problems.empty());
}

}  // namespace exsect::traced_curves_test
