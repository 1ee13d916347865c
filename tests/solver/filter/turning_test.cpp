#include "filter/turning.h"

#include <cmath>

#include "known_curve.h"

namespace exsect::turning_test {
namespace {

using namespace exsect::filter;
using exsect::testing::HeightCoefficients;
using exsect::testing::q;

/// The only curve of a graph and its plane, from side to side.
struct OpenCurve : testing::KnownCurve {
  filter::Trace trace = arc();
  using KnownCurve::KnownCurve;
};

KnownTurning<Biquadratic> one_parameter() {
  KnownTurning<Biquadratic> known;
  known.coincident = {0, 1, 0, 1};
  return known;
}

}  // namespace

TEST_CASE("filter turning: the vertex of a parabola, once for both patches or once each", "[filter]") {
  OpenCurve curve(testing::kParabola);
  CHECK(moves(curve.trace));
  std::vector<Turn> turns;
  REQUIRE(find_turns<Biquadratic>(curve.pair, curve.trace, one_parameter(), turns) == TurnSearch::done);
  REQUIRE(turns.size() == 1);
  CHECK(turns[0].parameter == 1);
  // Centred parameters.
  CHECK(std::fabs(turns[0].ball.middle[0] + 0.5 - 1.0 / 3) <= turns[0].ball.radius + 1e-15);
  CHECK(std::fabs(turns[0].ball.middle[1] + 0.25) <= turns[0].ball.radius + 1e-15);
  CHECK(turns[0].ball.radius < 1e-6);

  // Without knowing that s is v two turning points in one place cannot be told apart.
  turns.clear();
  CHECK(find_turns<Biquadratic>(curve.pair, curve.trace, KnownTurning<Biquadratic>{}, turns) ==
        TurnSearch::not_separated);
  // What is not asked for is not looked for.
  auto unasked = one_parameter();
  unasked.unasked = {false, true, false, true};
  turns.clear();
  CHECK(find_turns<Biquadratic>(curve.pair, curve.trace, unasked, turns) == TurnSearch::done);
  CHECK(turns.empty());
}

TEST_CASE("filter turning: none on the hyperbola, one on a parabola in either direction", "[filter]") {
  OpenCurve hyperbola(testing::kHyperbola);
  std::vector<Turn> turns;
  CHECK(find_turns<Biquadratic>(hyperbola.pair, hyperbola.trace, one_parameter(), turns) == TurnSearch::done);
  CHECK(turns.empty());

  // (u - 1/4)(u - 3/4) = (v - 1/2) / 4 turns in v over u = 1/2; written over v it turns in u.
  for (const bool exchanged : {false, true}) {
    HeightCoefficients h = {{{q(3, 16) + q(1, 8), q(-1, 4), 0}, {-1, 0, 0}, {1, 0, 0}}};
    if (exchanged)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < i; ++j) std::swap(h[i][j], h[j][i]);
    OpenCurve wave(h);
    turns.clear();
    REQUIRE(find_turns<Biquadratic>(wave.pair, wave.trace, one_parameter(), turns) == TurnSearch::done);
    REQUIRE(turns.size() == 1);
    CHECK(turns[0].parameter == (exchanged ? 0 : 1));
    CHECK(turns[0].ball.middle[exchanged ? 1 : 0] == Approx(0).margin(1e-9));
  }
}

TEST_CASE("filter turning: a line that is one point does not move", "[filter]") {
  filter::Trace trace;
  CHECK_FALSE(moves(trace));
  KnownTurning<Biquadratic> known;
  known.constant = {true, true, true, false};
  CHECK(known.is_one_point());
  known.constant[0] = false;
  CHECK_FALSE(known.is_one_point());
}

}  // namespace exsect::turning_test
