#include "filter/round_trace.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "trace/tube_tracer.h"

namespace exsect {

// What the tracer asks of a box (trace/tube_tracer.h).
inline const RoundBox& landmark_box(const RoundBox& landmark) { return landmark; }
/// The chart has no ends on the curve.
inline bool may_be_in_domain(const RoundBox&) { return true; }
inline TraceFailure trace_failure(const RoundBox& at, const char* why) {
  return {{at.centre.at[0][0], at.centre.at[0][1], at.centre.at[1][0], at.centre.at[1][1]}, why};
}

namespace {

/// Above what a place errs by that is moved by an offset.
constexpr double kJointRadius = 0x1p-44;

/// The tubes of a curve (trace/tube_tracer.h).
class RoundCourse {
 public:
  using Box = RoundBox;
  using Offset = DoubleBall;
  using Tube = RoundTube;
  using Trace = RoundTrace;
  using Landmarks = std::vector<RoundBox>;
  static constexpr Steps steps = kRoundSteps;
  static constexpr const char* too_small = "the steps along the curve become too small for doubles";
  static constexpr bool starts_inside = false;

  explicit RoundCourse(const RoundChart& chart) : chart_(chart) {}

  const char* set_out(const RoundTrace&, const RoundBox& position) {
    position_ = position;
    const RoundJet f = chart_.quick_jet(position.centre);
    const std::array<double, 2> speed = chart_.speeds({position.centre, {}});
    const double a = f.first[0].approximation(), b = f.first[1].approximation();
    axis_ = std::fabs(b) * speed[0] >= std::fabs(a) * speed[1] ? 0 : 1;
    speed_ = speed[axis_] / chart_.unit();
    direction_ = (axis_ == 0 ? b > 0 : a < 0) ? 1 : -1;
    slope_ = axis_ == 0 ? -a / b : -b / a;
    return nullptr;
  }

  bool may_try() const { return step_ >= steps.least; }
  void shorter(bool /*had*/) { step_ *= 0.5; }

  /// A tube around a point half a step ahead, that contains the position.
  std::optional<RoundTube> next_tube() const {
    const double ahead = 0.5 * step_ / speed_;
    if (!(ahead < 0.5)) return std::nullopt;
    const std::size_t other = 1 - axis_;
    RoundPlace centre = chart_.moved(position_.centre, axis_, direction_ * ahead);
    double move = slope_ * direction_ * ahead;
    for (int newton = 0; newton < 4; ++newton) {
      if (!(std::fabs(move) < 1)) return std::nullopt;
      centre = chart_.moved(centre, other, move);
      const RoundJet f = chart_.quick_jet(centre);
      move = -f.value.approximation() / f.first[other].approximation();
      if (std::fabs(move) < 0x1p-30) break;
    }
    std::optional<RoundTube> tube = round_tube(chart_, centre, axis_, 1.02 * ahead + 2 * kJointRadius);
    const bool is_good = tube && tube->contraction <= steps.worst && direction_of(*tube) == direction_ &&
                         contains(*tube, position_);
    return is_good ? tube : std::nullopt;
  }

  int direction() const { return direction_; }

  std::pair<double, RoundBox> joint(const RoundTube& tube) const {
    const double to = 0.4931 * direction_ * step_ / speed_;
    const NearCurve near = near_curve(tube, to, tube.slope * to, kJointRadius);
    RoundBox box{near.place, {}};
    box.reach[tube.axis] = kJointRadius;
    box.reach[1 - tube.axis] = near.error + kJointRadius * (1 + tube.rate / tube.speed);
    return {to, box};
  }

  void taken(const RoundTube& tube) {
    step_ = std::min(std::clamp(steps.good / tube.contraction, 0.5, 2.0) * step_, steps.longest);
  }

 private:
  static int direction_of(const RoundTube& tube) { return tube.axis == 0 ? tube.sign : -tube.sign; }

  const RoundChart& chart_;
  RoundBox position_;
  std::size_t axis_ = 0;
  int direction_ = 1;
  double speed_ = 1;
  double slope_ = 0;
  double step_ = steps.first;
};

const StopRequest kNoStop;

}  // namespace

std::optional<RoundTrace> round_trace(const RoundChart& chart, const std::vector<RoundBox>& landmarks,
                                      std::size_t start) {
  auto trace = TubeTracer<RoundCourse>(RoundCourse(chart), landmarks, kNoStop)
                   .run(landmarks[start], static_cast<int>(start));
  auto* found = std::get_if<RoundTrace>(&trace);
  return found != nullptr ? std::optional(std::move(*found)) : std::nullopt;
}

}  // namespace exsect
