#include "filter/trace.h"

#include <cmath>

#include "known_curve.h"

namespace exsect::trace_test {
namespace {

using testing::KnownCurve;
using testing::q;

void check_chain(const filter::Trace& trace, bool closed) {
  const std::size_t count = trace.pieces.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const auto last = filter::point_at(trace.pieces[i].tube, trace.pieces[i].range.to());
    const auto& next = trace.pieces[(i + 1) % count];
    const auto first = filter::point_at(next.tube, next.range.from());
    for (std::size_t j = 0; j < 4; ++j)
      CHECK(std::fabs(last.middle[j] - first.middle[j]) <= last.radius + first.radius + 1e-9);
  }
}

}  // namespace

TEST_CASE("filter trace: from side to side, along the formula", "[filter]") {
  const KnownCurve curve(testing::kHyperbola);
  REQUIRE(curve.points.size() == 2);
  for (const std::size_t start : {0U, 1U}) {
    const auto trace = filter::trace_arc<filter::Biquadratic>(curve.pair, curve.points, start);
    REQUIRE(trace);
    CHECK(trace->start == static_cast<int>(start));
    CHECK(trace->end == 1 - static_cast<int>(start));
    check_chain(*trace, false);
    for (const filter::Piece& piece : trace->pieces) {
      const auto ball = filter::point_at(piece.tube, piece.range.at(0.5));
      const double u = ball.middle[0] + 0.5, v = ball.middle[1] + 0.5;
      CHECK(std::fabs(u * v - 0.25) <= 2 * ball.radius + 1e-15);
    }
  }
}

TEST_CASE("filter trace: a closed curve comes back to its seed", "[filter]") {
  const KnownCurve curve(testing::kCircle);
  CHECK(curve.points.empty());
  // (1/2 + 1/3 3/5, 1/2 + 1/3 4/5)
  const filter::Tube seed = curve.tube(0.7, 0.5 + 0.8 / 3, 0, 0x1p-8);
  const auto trace = filter::trace_loop<filter::Biquadratic>(curve.pair, curve.points, seed, 0);
  REQUIRE(trace);
  CHECK(trace->start == -1);
  CHECK(trace->end == -1);
  check_chain(*trace, true);
  double length = 0;
  for (const filter::Piece& piece : trace->pieces)
    for (int i = 0; i < 8; ++i) {
      const auto a = filter::point_at(piece.tube, piece.range.at(i / 8.0));
      const auto b = filter::point_at(piece.tube, piece.range.at((i + 1) / 8.0));
      length += std::hypot(a.middle[0] - b.middle[0], a.middle[1] - b.middle[1]);
    }
  CHECK(length == Approx(2 * std::acos(-1.0) / 3).epsilon(0.001));
}

TEST_CASE("filter trace: it does not pass a crossing, and says where it got to", "[filter]") {
  // The crossing of kCrossing, (u - 1/2)(v - 1/2), with lines that are none of parameters: a^2 = b^2 / 4.
  const testing::HeightCoefficients lines = {{{q(3, 16), q(1, 4), q(-1, 4)}, {-1, 0, 0}, {1, 0, 0}}};
  const KnownCurve curve(lines);
  REQUIRE(curve.points.size() == 4);
  for (std::size_t start = 0; start < 4; ++start) {
    filter::Vec4 stuck = {1, 1, 1, 1};
    CHECK_FALSE(filter::trace_arc<filter::Biquadratic>(curve.pair, curve.points, start, &stuck));
    for (const double w : stuck) CHECK(std::fabs(w) < 0.01);
  }
}

}  // namespace exsect::trace_test
