#include "trace/tracer.h"

#include <cmath>
#include <utility>

#include "support/known_curves.h"
#include "trace/landmark_tangent.h"
#include "trace/tube_points.h"

namespace exsect::tracer_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

}  // namespace

TEST_CASE("a circle is traced once around", "[tracer]") {
  const Trace<DoubleBall> trace = circle_trace();
  CHECK(trace.start == -1);
  CHECK(passes_through(trace, on_diagonal(q(1, 6), q(1, 2))));
  CHECK_FALSE(passes_through(trace, on_diagonal(q(1, 2), q(1, 2))));
  double length = 0;  // the chords of one turn add up to a little less than the circumference
  for (const auto& piece : trace.pieces) {
    constexpr int parts = 8;
    const auto at = [&](int i) {
      return point_at(piece.tube, piece.range.at(static_cast<double>(i) / parts));
    };
    for (int i = 0; i < parts; ++i) {
      const auto a = at(i);
      const auto b = at(i + 1);
      length += std::hypot(a[0].approximation() - b[0].approximation(),
                           a[1].approximation() - b[1].approximation());
    }
  }
  CHECK(length == Approx(2 * std::acos(-1.0) / 3).epsilon(0.001));
}

TEST_CASE("an arc ends at the first landmark met", "[tracer]") {
  const auto system = system_of<DoubleBall>(kParabola);
  // v = 1/4 + (u-1/3)^2 over u in [0,1]: ends at (0, 13/36) and (1, 25/36); the third landmark lies off the
  // curve.
  const Landmarks<DoubleBall> landmarks = {on_diagonal(0, q(13, 36)), on_diagonal(1, q(25, 36)),
                                           on_diagonal(1, q(26, 36))};
  const auto trace = require_trace(trace_arc(system, landmarks, 0, 1, {}));
  CHECK(trace.start == 0);
  CHECK(trace.end == 1);
  // In the wrong direction the curve leaves the domain at once: a failure, never a result.
  CHECK(std::holds_alternative<TraceFailure>(trace_arc(system, landmarks, 0, -1, {})));
  // Stopping on request is a failure with its reason.
  CHECK(std::holds_alternative<TraceFailure>(trace_arc(system, landmarks, 0, 1, [] { return true; })));
}

/// The arc u + v = e across a corner, in both directions. At its end it would be left again against T.
template <class Ball>
void check_arc_across_a_corner(const Rational& e) {
  const auto system = system_of<Ball>({{{-e, 1, 0}, {1, 0, 0}, {0, 0, 0}}});
  const Landmarks<Ball> landmarks = {on_diagonal<Ball>(0, e), on_diagonal<Ball>(e, 0)};
  for (const int start : {0, 1}) {
    CAPTURE(e, start);
    const BallPoint<Ball> tangent =
        Expansion<Ball>(system, landmarks[static_cast<std::size_t>(start)]).tangent();
    const int sign = tangent[start == 0 ? 0 : 1].certain_sign();
    REQUIRE(sign != 0);
    const auto outcome = trace_arc(system, landmarks, start, sign, {});
    REQUIRE(std::holds_alternative<Trace<Ball>>(outcome));
    const auto& trace = std::get<Trace<Ball>>(outcome);
    CHECK(trace.end == 1 - start);
    CHECK(arriving_direction(trace) == -sign);
    CHECK(passes_through(trace, on_diagonal<Ball>(e / 3, e - e / 3)));
    CHECK_FALSE(passes_through(trace, on_diagonal<Ball>(-e / 3, e + e / 3)));
    CHECK_FALSE(passes_through(trace, on_diagonal<Ball>(e + e / 3, -e / 3)));
  }
}

TEST_CASE("an arc shorter than the rounding of its offsets keeps its direction", "[tracer]") {
  for (const long bits : {2L, 10L, 30L, 45L}) {
    check_arc_across_a_corner<DoubleBall>(power_of_two(-bits));
  }
  for (const long bits : {2L, 45L, 58L, 60L, 90L}) {
    check_arc_across_a_corner<DoubleDoubleBall>(power_of_two(-bits));
  }
  for (const long bits : {58L, 90L, 150L, 200L}) {
    check_arc_across_a_corner<ArbBall<256>>(power_of_two(-bits) / 3);
  }
}

TEST_CASE("tracing into a crossing fails", "[tracer]") {
  const auto system = system_of<DoubleBall>(kCrossing);
  const Landmarks<DoubleBall> landmarks = {on_diagonal(0, q(1, 2)), on_diagonal(1, q(1, 2))};
  for (const int sign : {1, -1}) {
    CHECK(std::holds_alternative<TraceFailure>(trace_arc(system, landmarks, 0, sign, {})));
  }
}

}  // namespace exsect::tracer_test
