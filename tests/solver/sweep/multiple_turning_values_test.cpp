#include "sweep/multiple_turning_values.h"

#include "support/known_curves.h"
#include "sweep/traced_curves.h"
#include "swept_pair.h"

namespace exsect::multiple_turning_values_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

TracedCurves<DoubleBall> traced(SweptPair& pair) {
  return trace_curves(pair.system, pair.landmarks, pair.data, pair.width, {});
}

}  // namespace

TEST_CASE("multiple turning values: simple roots are decided, a double one without a star is not") {
  SweptPair circle(graph_patch(kCircle), plane_patch());
  const TracedCurves<DoubleBall> curves = traced(circle);
  const auto undecided = [&](int multiplicity, const TracedCurves<DoubleBall>& known) {
    circle.data.turning->values = {{RealAlgebraic(q(1, 6)), multiplicity}, {RealAlgebraic(q(5, 6)), 1}};
    return undecided_turning_values(circle.data, known, circle.width);
  };
  CHECK(undecided(1, {}).empty());
  // The regular turning point of the circle over 1/6 takes up one; were there more, all points of the fibre
  // over the rational value are known to be on the circle.
  CHECK(undecided(3, curves).empty());
  const auto left = undecided(3, {});
  REQUIRE(left.size() == 1);
  CHECK(left[0] == &circle.data.turning->values[0]);
}

}  // namespace exsect::multiple_turning_values_test
