#include "filter/ended_search.h"

#include "known_curve.h"

namespace exsect::ended_search_test {
namespace {

using testing::KnownCurve;
using testing::q;

Incomplete ended(const testing::HeightCoefficients& h, double u, double v) {
  const BezierPatch x = testing::graph_patch(h), y = testing::larger_plane();
  const filter::Pair pair = filter::make_pair(x, y).value();
  const IntersectResult result = filter::ended_at<filter::Biquadratic>(pair, KnownCurve::centred(u, v));
  CHECK(result.status == Status::incomplete);
  CHECK(result.graph.nodes.empty());
  REQUIRE(result.incomplete.size() == 2);
  // The whole domain, as it has not been searched.
  const ParameterBox& all = result.incomplete[1].where;
  for (const RationalInterval& range : all) CHECK((range.lower == 0 && range.upper == 1));
  return result.incomplete[0];
}

bool holds(const ParameterBox& box, const Rational& u, const Rational& v) {
  return box[0].lower <= u && u <= box[0].upper && box[1].lower <= v && v <= box[1].upper &&
         box[0].width() < q(1, 10);
}

}  // namespace

TEST_CASE("ended search: next to a touch point it is a tangency", "[filter]") {
  const Incomplete at = ended({{{q(1, 2), -1, 1}, {-1, 0, 0}, {1, 0, 0}}}, 0.5 + 1e-6, 0.5);
  CHECK(at.reason == Reason::tangency);
  CHECK(holds(at.where, q(1, 2), q(1, 2)));
  CHECK_FALSE(at.why.empty());
}

TEST_CASE("ended search: where two branches cross it is a crossing", "[filter]") {
  const Incomplete at = ended({{{q(3, 16), q(1, 4), q(-1, 4)}, {-1, 0, 0}, {1, 0, 0}}}, 0.5, 0.5 + 1e-7);
  CHECK(at.reason == Reason::crossing);
  CHECK(holds(at.where, q(1, 2), q(1, 2)));
}

TEST_CASE("ended search: on a regular curve nothing is known of the reason", "[filter]") {
  const Incomplete at = ended(testing::kHyperbola, 0.5, 0.5);
  CHECK(at.reason == Reason::not_decided);
  CHECK(holds(at.where, q(1, 2), q(1, 2)));
}

}  // namespace exsect::ended_search_test
