// Following circles from landmark to landmark.
#include "filter/section_trace.h"

#include <algorithm>
#include <cmath>

#include "square_section.h"
#include "support/catch.h"

namespace exsect::section_trace_test {
namespace {

using square_section::circle;

std::size_t nearest(const std::vector<SectionLandmark>& landmarks, double p, double q) {
  const auto distance = [&](const SectionLandmark& at) {
    return std::hypot(at.box.centre[0] - p, at.box.centre[1] - q);
  };
  return static_cast<std::size_t>(std::ranges::min_element(landmarks, {}, distance) - landmarks.begin());
}

}  // namespace

TEST_CASE("section trace: around a circle clockwise, with what is outside to the left") {
  const SquareForm f = circle(0, 0, Rational(1, 2));
  const auto landmarks = section_landmarks(f, true, {}).value();
  for (int i = 0; i < 4; ++i) {
    const double turn = std::acos(0.0) * i;
    const std::size_t from = nearest(landmarks, std::cos(turn) / 2, std::sin(turn) / 2);
    const std::size_t to = nearest(landmarks, std::sin(turn) / 2, -std::cos(turn) / 2);
    CHECK(section_direction(f, landmarks[from]) == 1);
    const auto trace = section_trace(f, landmarks, from, {});
    REQUIRE(trace);
    CHECK(trace->start == static_cast<int>(from));
    CHECK(trace->end == static_cast<int>(to));
    for (std::size_t k = 0; k + 1 < trace->pieces.size(); ++k) {
      const auto& piece = trace->pieces[k];
      const PlaceNearCurve joint =
          place_near_curve(f, piece.tube, piece.range.to(), piece.tube.slope * piece.range.to(), 0);
      CHECK(std::fabs(std::hypot(joint.place[0], joint.place[1]) - 0.5) <= 1e-12);
      CHECK(contains(trace->pieces[k + 1].tube, {joint.place, {1e-13, 1e-13}}));
    }
  }
}

TEST_CASE("section trace: from side to side, and in at every second point") {
  const SquareForm f = circle(0, 0, Rational(5, 4));
  const auto landmarks = section_landmarks(f, true, {}).value();
  int in = 0;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const int direction = section_direction(f, landmarks[i]);
    const auto& [p, q] = landmarks[i].box.centre;
    // Clockwise at (p,q) is along (q,-p).
    CHECK(direction == ((landmarks[i].coordinate == 0 ? q * p : -p * q) < 0 ? 1 : -1));
    if (direction < 0) continue;
    ++in;
    const auto trace = section_trace(f, landmarks, i, {});
    REQUIRE(trace);
    const auto& end = landmarks[static_cast<std::size_t>(trace->end)];
    CHECK(section_direction(f, end) == -1);
    CHECK(end.coordinate != landmarks[i].coordinate);
    CHECK(std::hypot(end.box.centre[0] - p, end.box.centre[1] - q) < 0.4);
  }
  CHECK(in == 4);
}

TEST_CASE("section trace: none without the landmark at its end, and none where it is told to stop") {
  const SquareForm f = circle(0, 0, Rational(5, 4));
  auto landmarks = section_landmarks(f, true, {}).value();
  std::size_t start = 0;
  while (section_direction(f, landmarks[start]) < 0) ++start;
  CHECK_FALSE(section_trace(f, landmarks, start, [] { return true; }));
  const SectionLandmark first = landmarks[start];
  landmarks = {first};
  const auto trace = section_trace(f, landmarks, 0, {});
  CHECK_FALSE(trace);  // it leaves the square
}

}  // namespace exsect::section_trace_test
