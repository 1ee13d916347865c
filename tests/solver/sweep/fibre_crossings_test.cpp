#include "sweep/fibre_crossings.h"

#include <algorithm>

#include "support/known_curves.h"
#include "sweep/traced_curves.h"
#include "swept_pair.h"

namespace exsect::fibre_crossings_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

AnalysedTrace<DoubleBall> only_curve(SweptPair& pair) {
  TracedCurves<DoubleBall> traced = trace_curves(pair.system, pair.landmarks, pair.data, pair.width, {});
  REQUIRE(traced.problems.empty());
  REQUIRE(traced.curves.size() == 1);
  return std::move(traced.curves.front());
}

}  // namespace

TEST_CASE("fibre crossings: a circle meets lines twice between its turning values, else not at all") {
  SweptPair circle(graph_patch(kCircle), plane_patch());
  const AnalysedTrace<DoubleBall> curve = only_curve(circle);
  for (const Rational& sample : {q(1, 10), q(1, 5), q(1, 2), q(82, 100), q(84, 100)}) {
    const std::size_t right = sample > q(1, 6) && sample < q(5, 6) ? 2 : 0;
    CHECK(crossings(circle.data, curve, sample) == right);
  }
  // As near to a turning value as it likes: the exact value decides where its box does not.
  for (const long bits : {20L, 60L, 200L}) {
    CHECK(crossings(circle.data, curve, q(1, 6) + power_of_two(-bits)) == 2U);
    CHECK(crossings(circle.data, curve, q(1, 6) - power_of_two(-bits)) == 0U);
  }
}

TEST_CASE("fibre crossings: a parabola across the square") {
  // v = 1/4 + (u - 1/3)^2 from (0, 13/36) to (1, 25/36): once over each u, over v twice below 13/36, then
  // once.
  for (const bool exchanged : {false, true}) {
    const BezierPatch x = graph_patch(kParabola), y = plane_patch();
    SweptPair pair(exchanged ? x.exchanged() : x, exchanged ? y.exchanged() : y);
    const AnalysedTrace<DoubleBall> curve = only_curve(pair);
    const bool along_u = (index(pair.data.turning->sweep) % 2 == 0) != exchanged;
    for (int k = 1; k < 40; ++k) {
      const Rational sample(k, 41);
      const std::size_t over_v = sample < q(1, 4) ? 0 : sample < q(13, 36) ? 2 : sample < q(25, 36) ? 1 : 0;
      CHECK(crossings(pair.data, curve, sample) == (along_u ? 1 : over_v));
    }
  }
}

}  // namespace exsect::fibre_crossings_test
