// The tracer's decisions alone, on curves that need no proof: a straight line, and one closed by a jump.
#include "trace/tube_tracer.h"

#include <cmath>

#include "support/catch.h"

namespace exsect::tube_tracer_test {
namespace {

using Point4 = BallPoint<DoubleBall>;

Point4 at(double u, double radius = 0x1p-30) {
  return {DoubleBall(u).widened(radius), DoubleBall(0.5).widened(radius), DoubleBall(0.5).widened(radius),
          DoubleBall(0.5).widened(radius)};
}

/// The part of the line (u, 1/2, 1/2, 1/2) with |u - centre| <= reach.
struct Segment {
  Point4 centre;
  double reach;
};
DoubleBall offset(const Segment& tube, const Point4& box) { return box[0] - tube.centre[0]; }
bool contains(const Segment& tube, const Point4& box) {
  const DoubleBall tau = offset(tube, box);
  return (tau + DoubleBall(tube.reach)).is_positive() && (DoubleBall(tube.reach) - tau).is_positive();
}
bool excludes(const Segment& tube, const Point4& box) {
  const DoubleBall tau = offset(tube, box);
  return (tau + DoubleBall(tube.reach)).is_negative() || (DoubleBall(tube.reach) - tau).is_negative();
}
Point4 point_at(const Segment& tube, double tau) { return at(tube.centre[0].approximation() + tau); }

/// Steps of 1/8, halved where the tracer asks for it.
template <bool StartsInside>
class Line {
 public:
  using Box = Point4;
  using Offset = DoubleBall;
  using Tube = Segment;
  using Trace = TubeTrace<Segment>;
  using Landmarks = exsect::Landmarks<DoubleBall>;
  static constexpr Steps steps = {0.125, 0x1p-20, 0x1p-20, 0.125, 0.25, 0.5, 12};
  static constexpr const char* too_small = "too small";
  static constexpr bool starts_inside = StartsInside;

  Line(int direction, double period) : direction_(direction), period_(period) {}
  const char* set_out(const TubeTrace<Segment>&, const Point4& position) {
    position_ = position[0].approximation();
    return nullptr;
  }
  bool may_try() const { return step_ >= steps.least; }
  void shorter(bool had) {
    CHECK(had);
    step_ *= 0.5;
  }
  std::optional<Segment> next_tube() const {
    return Segment{at(position_ + 0.5 * direction_ * step_, 0), 0.51 * step_};
  }
  int direction() const { return direction_; }
  /// The line jumps back by the period, so that it is closed.
  std::pair<double, Point4> joint(const Segment& tube) const {
    const double to = 0.5 * direction_ * step_;
    const double u = tube.centre[0].approximation() + to;
    return {to, at(u > 0.75 ? u - period_ : u)};
  }
  void taken(const Segment&) { step_ = steps.first; }

 private:
  int direction_;
  double period_;
  double position_ = 0;
  double step_ = steps.first;
};

using Outcome = std::variant<TubeTrace<Segment>, TraceFailure>;

template <bool StartsInside = true>
Outcome follow(const Landmarks<DoubleBall>& landmarks, const Point4& from, int start, int direction = 1,
               double period = 0, const StopRequest& stop = {}) {
  return TubeTracer<Line<StartsInside>>({direction, period}, landmarks, stop).run(from, start);
}

}  // namespace

TEST_CASE("a trace ends at the first landmark ahead", "[tube_tracer]") {
  const Landmarks<DoubleBall> landmarks = {at(0.9), at(0.4), at(0.1), at(0.42), at(0.05)};
  for (const int direction : {1, -1}) {
    const Outcome outcome = follow(landmarks, landmarks[2], 2, direction);
    REQUIRE(std::holds_alternative<TubeTrace<Segment>>(outcome));
    const auto& trace = std::get<TubeTrace<Segment>>(outcome);
    CHECK(trace.start == 2);
    CHECK(trace.end == (direction > 0 ? 1 : 4));
    CHECK(trace.ends[0][0].approximation() == 0.1);
    CHECK(trace.ends[1][0].approximation() == (direction > 0 ? 0.4 : 0.05));
    for (std::size_t i = 0; i < trace.pieces.size(); ++i) {
      const auto& [tube, range] = trace.pieces[i];
      CHECK(range.direction() == direction);
      const double from =
          i == 0 ? 0.1 : trace.pieces[i - 1].tube.centre[0].approximation() + trace.pieces[i - 1].range.to();
      CHECK(std::fabs(tube.centre[0].approximation() + range.from() - from) < 1e-8);
    }
    const auto& last = trace.pieces.back();
    CHECK(std::fabs(last.tube.centre[0].approximation() + last.range.to() -
                    trace.ends[1][0].approximation()) < 1e-8);
  }
}

TEST_CASE("a landmark across the end of a tube asks for a shorter one", "[tube_tracer]") {
  const Landmarks<DoubleBall> landmarks = {at(0.1), at(0.1 + 0.125 * 1.01, 0x1p-6)};
  const Outcome outcome = follow(landmarks, landmarks[0], 0);
  REQUIRE(std::holds_alternative<TubeTrace<Segment>>(outcome));
  const auto& trace = std::get<TubeTrace<Segment>>(outcome);
  CHECK(trace.end == 1);
  CHECK(trace.pieces.front().tube.reach < 0.51 * 0.125);
}

TEST_CASE("what is not decided is a failure with its place", "[tube_tracer]") {
  const auto why = [](const Outcome& outcome) {
    REQUIRE(std::holds_alternative<TraceFailure>(outcome));
    return std::get<TraceFailure>(outcome);
  };
  const TraceFailure outside = why(follow({at(0.5)}, at(0.5), 0));
  CHECK(outside.why == "too small");
  CHECK(std::fabs(outside.where[0] - 1) < 1e-5);
  CHECK(why(follow({at(0.5), at(0.6), at(0.6 + 0x1p-31)}, at(0.5), 0)).why == "too small");
  CHECK(why(follow({at(0.5)}, at(0.5), 0, 1, 0, [] { return true; })).why == "the work cap was reached");
  CHECK(why(follow({at(0.3)}, at(0.3), 0, 1, 0.25)).why == "too many steps along one curve");
}

TEST_CASE("a closed curve ends where it began", "[tube_tracer]") {
  const auto closes = [](const Outcome& outcome, double first, double last) {
    REQUIRE(std::holds_alternative<TubeTrace<Segment>>(outcome));
    const auto& trace = std::get<TubeTrace<Segment>>(outcome);
    CHECK(trace.start == -1);
    CHECK(trace.end == -1);
    const auto& begin = trace.pieces.front();
    const auto& end = trace.pieces.back();
    CHECK(std::fabs(begin.tube.centre[0].approximation() + begin.range.from() - first) < 1e-8);
    CHECK(std::fabs(end.tube.centre[0].approximation() + end.range.to() - last) < 1e-8);
  };
  const double inside = 0.3 + 0.61803 * 0.125;
  closes(follow<true>({at(0.1)}, at(0.3), -1, 1, 0.55), inside, inside);
  closes(follow<false>({at(0.1)}, at(0.3), -1, 1, 0.55), 0.3, 0.3);
  // A tube that ends within the box of the beginning would lead past it.
  closes(follow<false>({at(0.1)}, at(0.3, 0x1p-6), -1, 1, 0.625), 0.3, 0.3);
}

}  // namespace exsect::tube_tracer_test
