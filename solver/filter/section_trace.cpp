#include "filter/section_trace.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "trace/tube_tracer.h"

namespace exsect {

// What the tracer asks of a box (trace/tube_tracer.h).
inline const SectionBox& landmark_box(const SectionLandmark& landmark) { return landmark.box; }
/// Every point on a side is a landmark.
inline bool may_be_in_domain(const SectionBox& box) {
  return std::fabs(box.centre[0]) - box.reach[0] <= 1 && std::fabs(box.centre[1]) - box.reach[1] <= 1;
}
inline TraceFailure trace_failure(const SectionBox& at, const char* why) {
  return {{at.centre[0], at.centre[1], 0, 0}, why};
}

namespace {

/// Above what the place of a joint errs by along the axis.
constexpr double kSectionJoint = 0x1p-48;

/// The tubes of a curve (trace/tube_tracer.h).
class SectionCourse {
 public:
  using Box = SectionBox;
  using Offset = DoubleBall;
  using Tube = SectionTube;
  using Trace = SectionTrace;
  using Landmarks = std::vector<SectionLandmark>;
  static constexpr Steps steps = kSectionSteps;
  static constexpr const char* too_small = "the steps along the curve become too small for doubles";
  static constexpr bool starts_inside = false;

  explicit SectionCourse(const SquareForm& f) : f_(f) {}

  const char* set_out(const SectionTrace&, const SectionBox& position) {
    position_ = position;
    const LocalForm f = f_.about(position.centre[0], position.centre[1]);
    const double a = f.derivative(1, 0).approximation(), b = f.derivative(0, 1).approximation();
    axis_ = std::fabs(b) >= std::fabs(a) ? 0 : 1;
    direction_ = (axis_ == 0 ? b > 0 : a < 0) ? 1 : -1;
    slope_ = axis_ == 0 ? -a / b : -b / a;
    return nullptr;
  }

  bool may_try() const { return step_ >= steps.least; }
  void shorter(bool /*had*/) { step_ *= 0.5; }

  /// A tube around a point half a step ahead, that contains the position.
  std::optional<SectionTube> next_tube() const {
    const double ahead = 0.5 * step_;
    const std::size_t other = 1 - axis_;
    std::array<double, 2> centre = position_.centre;
    centre[axis_] += direction_ * ahead;
    double move = slope_ * direction_ * ahead;
    for (int newton = 0; newton < 4; ++newton) {
      centre[other] += move;
      if (!(std::fabs(centre[0]) <= SquareForm::reach && std::fabs(centre[1]) <= SquareForm::reach))
        return std::nullopt;
      const LocalForm f = f_.about(centre[0], centre[1]);
      move = -f.derivative(0, 0).approximation() /
             f.derivative(axis_ == 0 ? 0 : 1, axis_ == 0 ? 1 : 0).approximation();
      if (std::fabs(move) < 0x1p-30) break;
    }
    std::optional<SectionTube> tube = section_tube(f_, centre, axis_, 1.02 * ahead + 2 * kSectionJoint);
    const bool is_good = tube && tube->contraction <= steps.worst && direction_of(*tube) == direction_ &&
                         contains(*tube, position_);
    return is_good ? tube : std::nullopt;
  }

  int direction() const { return direction_; }

  std::pair<double, SectionBox> joint(const SectionTube& tube) const {
    const double to = 0.4931 * direction_ * step_;
    const PlaceNearCurve near = place_near_curve(f_, tube, to, tube.slope * to, kSectionJoint);
    SectionBox box{near.place, {}};
    box.reach[tube.axis] = kSectionJoint;
    box.reach[1 - tube.axis] = near.error + kSectionJoint * (1 + tube.slopes.upper_magnitude());
    return {to, box};
  }

  void taken(const SectionTube& tube) {
    step_ = std::min(std::clamp(steps.good / tube.contraction, 0.5, 2.0) * step_, steps.longest);
  }

 private:
  static int direction_of(const SectionTube& tube) { return tube.axis == 0 ? tube.sign : -tube.sign; }

  const SquareForm& f_;
  SectionBox position_;
  std::size_t axis_ = 0;
  int direction_ = 1;
  double slope_ = 0;
  double step_ = steps.first;
};

}  // namespace

std::optional<SectionTrace> section_trace(const SquareForm& f, const std::vector<SectionLandmark>& landmarks,
                                          std::size_t start, const StopRequest& stop) {
  auto trace = TubeTracer<SectionCourse>(SectionCourse(f), landmarks, stop)
                   .run(landmarks[start].box, static_cast<int>(start));
  auto* found = std::get_if<SectionTrace>(&trace);
  return found != nullptr ? std::optional(std::move(*found)) : std::nullopt;
}

/// The direction is (f_q, -f_p), which is ahead where it is along the side's inner normal.
int section_direction(const SquareForm& f, const SectionLandmark& landmark) {
  if (landmark.side == 0) return 1;
  const auto& [centre, reach] = landmark.box;
  const LocalForm local = f.about(centre[0], centre[1]);
  const int across = landmark.coordinate == 0
                         ? local.derivative_over(0, 1, reach[0], reach[1]).certain_sign()
                         : -local.derivative_over(1, 0, reach[0], reach[1]).certain_sign();
  return -landmark.side * across;
}

}  // namespace exsect
