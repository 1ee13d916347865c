// Traces of the curves of two cylinders from landmark to landmark.
#include "filter/round_trace.h"

#include "support/catch.h"

namespace exsect::round_trace_test {

TEST_CASE("round trace: from landmark to landmark, each arrived at once") {
  const RoundChart chart = RoundChart::of(ImplicitSurface::cylinder({0, 0, 0}, {1, 0, 0}, 1),
                                          ImplicitSurface::cylinder({0, 0, 0}, {0, 0, 1}, 2))
                               .value();
  const auto landmarks = round_landmarks(chart).value();
  std::vector<int> arrivals(landmarks.size(), 0);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const auto trace = round_trace(chart, landmarks, i);
    REQUIRE(trace);
    CHECK(trace->start == static_cast<int>(i));
    CHECK(trace->end != trace->start);
    ++arrivals[static_cast<std::size_t>(trace->end)];
    for (std::size_t k = 0; k + 1 < trace->pieces.size(); ++k) {
      const auto &one = trace->pieces[k], &next = trace->pieces[k + 1];
      const RoundPlace joint =
          near_curve(one.tube, one.range.to(), one.tube.slope * one.range.to(), 1e-12).place;
      CHECK(contains(next.tube, {joint, {1e-11, 1e-11}}));
    }
  }
  CHECK(arrivals == std::vector<int>(landmarks.size(), 1));
}

}  // namespace exsect::round_trace_test
