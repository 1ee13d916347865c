#include "filter/exact_turning.h"

#include "known_curve.h"

namespace exsect::exact_turning_test {
namespace {

using filter::Biquadratic;

}  // namespace

TEST_CASE("exact turning: on a graph and its plane u turns with r, and v with s", "[filter]") {
  const testing::KnownCurve curve(testing::kParabola);
  filter::ExactTurning<Biquadratic> exact(curve.x, curve.y);
  filter::KnownTurning<Biquadratic> known;
  const filter::Trace trace = curve.arc();
  exact.add_to(known, trace, curve.points);
  CHECK(known.coincident == std::array<std::size_t, 4>{2, 3, 0, 1});
  CHECK(known.constant == std::array<bool, 4>{});
  CHECK_FALSE(known.is_one_point());
  // With that the vertex of the parabola is one turning point of v.
  filter::Trace again = trace;
  std::vector<filter::Turn> turns;
  REQUIRE(filter::find_turns<Biquadratic>(curve.pair, again, known, turns) == filter::TurnSearch::done);
  CHECK(turns.size() == 1);
}

TEST_CASE("exact turning: along a line of parameters one is constant", "[filter]") {
  // v = 1/3 + (u - 1/2) 0: the plane z = v - 1/3.
  const testing::KnownCurve curve(
      testing::HeightCoefficients{{{testing::q(-1, 3), 1, 0}, {0, 0, 0}, {0, 0, 0}}});
  filter::ExactTurning<Biquadratic> exact(curve.x, curve.y);
  filter::KnownTurning<Biquadratic> known;
  exact.add_to(known, curve.arc(), curve.points);
  CHECK(known.constant[1]);
  CHECK_FALSE(known.constant[0]);
}

}  // namespace exsect::exact_turning_test
