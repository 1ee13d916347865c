#include "trace/tube_trace.h"

#include <cmath>

#include "support/families.h"
#include "support/known_curves.h"
#include "trace/tangential_arc.h"
#include "trace/tube_points.h"

namespace exsect::tube_trace_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

/// Every piece ends where the next one begins; `point` gives the point of a tube at an offset.
template <class Trace, class PointAt>
void check_chain(const Trace& trace, const PointAt& point, double doubt) {
  const std::size_t count = trace.pieces.size();
  REQUIRE(count > 0);
  const bool closed = trace.start < 0;
  CHECK(closed == (trace.end < 0));
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const auto& here = trace.pieces[i];
    const auto& next = trace.pieces[(i + 1) % count];
    const auto last = point(here.tube, here.range.to()), first = point(next.tube, next.range.from());
    for (std::size_t j = 0; j < 4; ++j) CHECK((last[j] - first[j]).lower_magnitude() <= doubt);
  }
}

}  // namespace

TEST_CASE("tube trace: the pieces of a closed curve are one chain, the last one ends at the first",
          "[trace]") {
  check_chain(
      circle_trace(), [](const auto& tube, double tau) { return point_at(tube, tau); }, 1e-12);
}

TEST_CASE("tube trace: an arc begins and ends in its landmarks, and its pieces are one chain", "[trace]") {
  const auto system = system_of<DoubleBall>(kParabola);
  const Landmarks<DoubleBall> ends = {on_diagonal(0, q(13, 36)), on_diagonal(1, q(25, 36))};
  const auto trace = require_trace(trace_arc(system, ends, 0, 1, {}));
  const auto point = [](const auto& tube, double tau) { return point_at(tube, tau); };
  check_chain(trace, point, 1e-12);
  const auto first = point(trace.pieces.front().tube, trace.pieces.front().range.from());
  const auto last = point(trace.pieces.back().tube, trace.pieces.back().range.to());
  for (std::size_t j = 0; j < 4; ++j) {
    CHECK((first[j] - ends[0][j]).lower_magnitude() < 1e-12);
    CHECK((last[j] - ends[1][j]).lower_magnitude() < 1e-12);
    CHECK((trace.ends[0][j] - ends[0][j]).lower_magnitude() == 0);
    CHECK((trace.ends[1][j] - ends[1][j]).lower_magnitude() == 0);
  }
}

TEST_CASE("tube trace: the same chain of tubes of another kind", "[trace]") {
  // (u - v/3 - 1/4)^2 touches the plane along u = v/3 + 1/4, from v = 0 to v = 1.
  const ExactCase line = families::tangent_curve(q(1, 3), families::Plane::square);
  const PairSystem<DoubleBall> system(line.x, line.y, Point{0, 0, 0}, 0);
  const Landmarks<DoubleBall> ends = {on_diagonal(q(1, 4), 0), on_diagonal(q(7, 12), 1)};
  const auto outcome = trace_contact(system, ends, on_diagonal(q(5, 12), q(1, 2)), {});
  REQUIRE(std::holds_alternative<TangentialArc<DoubleBall>>(outcome));
  const auto& arc = std::get<TangentialArc<DoubleBall>>(outcome);
  CHECK(arc.start + arc.end == 1);
  check_chain(
      arc, [&](const auto& tube, double tau) { return point_at(system, tube, tau); }, 1e-12);
}

}  // namespace exsect::tube_trace_test
