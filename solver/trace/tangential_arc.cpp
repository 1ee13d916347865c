#include "trace/tangential_arc.h"

#include <algorithm>

#include "trace/tangential_enclosure.h"
#include "trace/tube_tracer.h"

namespace exsect {

namespace {

template <class Ball>
constexpr double kLeastArcStep = LeastStep<Ball>::of(kContactSteps);

/// The tubes of the trace in one direction from the seed (tube_tracer.h).
template <class Ball>
class ContactCourse {
 public:
  using Box = BallPoint<Ball>;
  using Offset = Ball;
  using Landmarks = exsect::Landmarks<Ball>;
  using Tube = TangentialTube<Ball>;
  using Trace = TangentialArc<Ball>;
  static constexpr Steps steps = kContactSteps;
  static constexpr const char* too_small =
      "the steps along a curve on which the patches touch become too small";
  static constexpr bool starts_inside = false;

  /// `direction`: the sign of the first tube's offsets.
  ContactCourse(const PairSystem<Ball>& system, int direction) : system_(system), at_seed_(direction) {}

  const char* set_out(const TangentialArc<Ball>& arc, const BallPoint<Ball>& position) {
    last_ = arc.pieces.empty() ? nullptr : &arc.pieces.back();
    position_ = position;
    keep_axis_ = false;
    return nullptr;
  }

  bool may_try() const { return step_ >= kLeastArcStep<Ball>; }

  /// With the last tube's axis, then with half the step.
  void shorter(bool /*had*/) {
    keep_axis_ = !keep_axis_ && last_ != nullptr;
    if (!keep_axis_) {
      step_ *= 0.5;
    }
  }

  /// A tube that reaches `step_` ahead, centred in the middle of the step.
  std::optional<Tube> next_tube() {
    const auto tube = ahead(keep_axis_ ? std::optional(last_->tube.axis) : std::nullopt);
    direction_ = tube ? direction_on(*tube) : 0;
    return direction_ != 0 ? tube : std::nullopt;
  }

  int direction() const { return direction_; }

  std::pair<double, BallPoint<Ball>> joint(const Tube& tube) const {
    const double to = 0.5 * direction_ * step_;
    return {to, point_at(system_, tube, to)};
  }

  void taken(const Tube& tube) {
    step_ = std::min(steps.longest, step_ * std::clamp(steps.good / tube.contraction, 0.7, 2.0));
  }

 private:
  std::optional<TangentialTube<Ball>> ahead(std::optional<std::size_t> axis) const {
    const auto here = certify_direction(axis);
    if (!here) {
      return std::nullopt;
    }
    const int direction = direction_on(*here);
    if (direction == 0) {
      return std::nullopt;
    }
    BallPoint<Ball> guess;
    for (std::size_t j = 0; j < 4; ++j) {
      guess[j] = (position_[j] + Ball(0.5 * direction * step_ * here->slope[j])).midpoint();
    }
    const auto centre = corrected_to_contact(system_, guess, here->axis, 2);
    if (!centre) {
      return std::nullopt;
    }
    auto tube = certify_tangential_tube(system_, *centre, 0.52 * step_, here->axis);
    return tube && contains(*tube, position_) ? tube : std::nullopt;
  }

  /// A tube around the position, which gives axis and direction.
  std::optional<TangentialTube<Ball>> certify_direction(std::optional<std::size_t> axis) const {
    for (double reach = 0.25 * step_; reach >= 0.25 * kLeastArcStep<Ball>; reach *= 0.25) {
      auto tube = certify_tangential_tube(system_, position_, reach, axis);
      if (tube && contains(*tube, position_)) {
        return tube;
      }
    }
    return std::nullopt;
  }

  /// The sign of this tube's offsets in the direction of the trace; 0: not known.
  int direction_on(const TangentialTube<Ball>& tube) const {
    if (last_ == nullptr) {
      return at_seed_;
    }
    const ArcEnclosure<Ball> there =
        enclosure_between(system_, last_->tube, last_->range.to(), last_->range.to());
    return there.slope[tube.axis].certain_sign() * last_->range.direction();
  }

  const PairSystem<Ball>& system_;
  int at_seed_;
  const TangentialPiece<Ball>* last_ = nullptr;
  BallPoint<Ball> position_;
  double step_ = steps.first;
  int direction_ = 0;
  bool keep_axis_ = false;
};

}  // namespace

template <class Ball>
std::variant<TangentialArc<Ball>, TraceFailure> trace_contact(const PairSystem<Ball>& system,
                                                              const Landmarks<Ball>& landmarks,
                                                              const BallPoint<Ball>& seed,
                                                              const StopRequest& stop) {
  const auto follow = [&](int direction) {
    return TubeTracer<ContactCourse<Ball>>({system, direction}, landmarks, stop).run(seed, -1);
  };
  auto forward = follow(1);
  if (std::holds_alternative<TraceFailure>(forward) || std::get<TangentialArc<Ball>>(forward).end < 0) {
    return forward;
  }
  auto backward = follow(-1);
  if (std::holds_alternative<TraceFailure>(backward)) {
    return backward;
  }
  const auto& ahead = std::get<TangentialArc<Ball>>(forward);
  const auto& behind = std::get<TangentialArc<Ball>>(backward);
  if (behind.end < 0) {
    return trace_failure(seed, "a curve is closed in one direction only");
  }
  TangentialArc<Ball> arc;
  for (auto piece = behind.pieces.rbegin(); piece != behind.pieces.rend(); ++piece) {
    arc.pieces.push_back({piece->tube, piece->range.reversed()});
  }
  arc.pieces.insert(arc.pieces.end(), ahead.pieces.begin(), ahead.pieces.end());
  arc.start = behind.end;
  arc.end = ahead.end;
  arc.ends = {behind.ends[1], ahead.ends[1]};
  return arc;
}

template <class Ball>
bool passes_through(const TangentialArc<Ball>& arc, const BallPoint<Ball>& box) {
  return std::any_of(arc.pieces.begin(), arc.pieces.end(),
                     [&](const TangentialPiece<Ball>& piece) { return contains(piece.tube, box); });
}

template <class Ball>
int certain_direction(const PairSystem<Ball>& system, const TangentialArc<Ball>& arc, int which,
                      std::size_t j) {
  const TangentialPiece<Ball>& piece = which == 0 ? arc.pieces.front() : arc.pieces.back();
  const double at = which == 0 ? piece.range.from() : piece.range.to();
  const double doubt = piece.range.doubt();
  return enclosure_between(system, piece.tube, at - doubt, at + doubt).slope[j].certain_sign() *
         piece.range.direction();
}

#define EXSECT_INSTANTIATE_TANGENTIAL(Ball)                                                         \
  template std::variant<TangentialArc<Ball>, TraceFailure> trace_contact(                           \
      const PairSystem<Ball>&, const Landmarks<Ball>&, const BallPoint<Ball>&, const StopRequest&); \
  template bool passes_through(const TangentialArc<Ball>&, const BallPoint<Ball>&);                 \
  template int certain_direction(const PairSystem<Ball>&, const TangentialArc<Ball>&, int, std::size_t);

EXSECT_INSTANTIATE_TANGENTIAL(DoubleBall)
EXSECT_INSTANTIATE_TANGENTIAL(DoubleDoubleBall)
EXSECT_INSTANTIATE_TANGENTIAL(ArbBall<256>)
EXSECT_INSTANTIATE_TANGENTIAL(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_TANGENTIAL

}  // namespace exsect
