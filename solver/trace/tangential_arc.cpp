#include "trace/tangential_arc.h"

#include <algorithm>
#include <cmath>

#include "trace/tangential_enclosure.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

constexpr double kFirstStep = 0.1;
template <class Ball>
constexpr double kLeastStep = 0x1p-30;
template <long Bits>
inline constexpr double kLeastStep<ArbBall<Bits>> = Bits > 256 ? 0x1p-450 : 0x1p-110;
constexpr double kGoodContraction = 0.3;
constexpr std::size_t kMostPieces = 20000;

template <class Ball>
TraceFailure failure(const BallPoint<Ball>& at, const char* why) {
  return {{at[0].approximation(), at[1].approximation(), at[2].approximation(), at[3].approximation()}, why};
}

/// The trace in one direction from the seed.
template <class Ball>
class ContactTracer {
 public:
  ContactTracer(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks, const StopRequest& stop)
      : system_(system), landmarks_(landmarks), stop_(stop) {}

  /// `direction`: the sign of the first tube's offsets.
  std::variant<TangentialArc<Ball>, TraceFailure> run(const BallPoint<Ball>& seed, int direction) {
    position_ = seed;
    seed_ = seed;
    direction_ = direction;
    while (arc_.pieces.size() < kMostPieces) {
      if (stop_ && stop_()) {
        return failure(position_, "the work cap was reached");
      }
      if (!advance()) {
        return failure(position_, "the steps along a curve on which the patches touch become too small");
      }
      if (finished_) {
        return std::move(arc_);
      }
    }
    return failure(position_, "too many steps along one curve");
  }

 private:
  bool advance() {
    for (; step_ >= kLeastStep<Ball>; step_ *= 0.5) {
      for (const bool keep_axis : {false, true}) {
        if (keep_axis && arc_.pieces.empty()) {
          continue;
        }
        const auto tube = next_tube(keep_axis ? std::optional(arc_.pieces.back().tube.axis) : std::nullopt);
        const int direction = tube ? direction_on(*tube) : 0;
        if (direction != 0 && accept(*tube, direction)) {
          return true;
        }
      }
    }
    return false;
  }

  /// A tube that reaches `step_` ahead, centred in the middle of the step.
  std::optional<TangentialTube<Ball>> next_tube(std::optional<std::size_t> axis) const {
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
    for (double reach = 0.25 * step_; reach >= 0.25 * kLeastStep<Ball>; reach *= 0.25) {
      auto tube = certify_tangential_tube(system_, position_, reach, axis);
      if (tube && contains(*tube, position_)) {
        return tube;
      }
    }
    return std::nullopt;
  }

  /// The sign of this tube's offsets in the direction of the trace; 0: not known.
  int direction_on(const TangentialTube<Ball>& tube) const {
    if (arc_.pieces.empty()) {
      return direction_;
    }
    const TangentialPiece<Ball>& last = arc_.pieces.back();
    const ArcEnclosure<Ball> there = enclosure_between(system_, last.tube, last.range.to(), last.range.to());
    return there.slope[tube.axis].certain_sign() * last.range.direction();
  }

  /// Decides every landmark on the tube; ends at the first one ahead, else moves on to the far end.
  bool accept(const TangentialTube<Ball>& tube, int direction) {
    const Ball here = offset(tube, position_);
    int met = -1;
    Ball met_at;
    for (int i = 0; i < static_cast<int>(landmarks_.size()); ++i) {
      const BallPoint<Ball>& box = landmarks_[static_cast<std::size_t>(i)];
      if (excludes(tube, box)) {
        continue;
      }
      const Ball at = offset(tube, box);
      const int ahead = direction * (at - here).certain_sign();
      if (ahead < 0) {
        continue;
      }
      if (ahead == 0 || !contains(tube, box)) {
        return false;
      }
      const int order = met < 0 ? -1 : direction * (at - met_at).certain_sign();
      if (order == 0) {
        return false;
      }
      if (order < 0) {
        met = i;
        met_at = at;
      }
    }
    const Ball back = offset(tube, seed_);
    const bool closes =
        arc_.pieces.size() > 2 && contains(tube, seed_) && direction * (back - here).certain_sign() > 0;
    if (closes && met >= 0) {
      return false;
    }
    if (met < 0 && !closes) {
      return move_to_end(tube, here, direction);
    }
    if (!add_piece(tube, here, closes ? back : met_at, direction)) {
      return false;
    }
    arc_.end = met;
    finished_ = true;
    return true;
  }

  /// Of the tube, between two offsets; false if they are not certainly in this direction.
  bool add_piece(const TangentialTube<Ball>& tube, const Ball& from, const Ball& to, int direction) {
    const auto range = PieceRange::between(from, to);
    if (!range || range->direction() != direction) {
      return false;
    }
    arc_.pieces.push_back({tube, *range});
    return true;
  }

  bool move_to_end(const TangentialTube<Ball>& tube, const Ball& here, int direction) {
    const double to = 0.5 * direction * step_;
    const BallPoint<Ball> end = point_at(system_, tube, to);
    for (const Ball& c : end) {
      if (c.is_negative() || (c - Ball(1)).is_positive()) {
        return false;  // left the domain without meeting a boundary point: take smaller steps
      }
    }
    if (!add_piece(tube, here, Ball(to), direction)) {
      return false;
    }
    position_ = end;
    step_ = std::min(0.25, step_ * std::clamp(kGoodContraction / tube.contraction, 0.7, 2.0));
    return true;
  }

  const PairSystem<Ball>& system_;
  const Landmarks<Ball>& landmarks_;
  const StopRequest& stop_;
  TangentialArc<Ball> arc_;
  BallPoint<Ball> position_;
  BallPoint<Ball> seed_;
  int direction_ = 1;
  double step_ = kFirstStep;
  bool finished_ = false;
};

}  // namespace

template <class Ball>
std::variant<TangentialArc<Ball>, TraceFailure> trace_contact(const PairSystem<Ball>& system,
                                                              const Landmarks<Ball>& landmarks,
                                                              const BallPoint<Ball>& seed,
                                                              const StopRequest& stop) {
  auto forward = ContactTracer<Ball>(system, landmarks, stop).run(seed, 1);
  if (std::holds_alternative<TraceFailure>(forward) || std::get<TangentialArc<Ball>>(forward).end < 0) {
    return forward;
  }
  auto backward = ContactTracer<Ball>(system, landmarks, stop).run(seed, -1);
  if (std::holds_alternative<TraceFailure>(backward)) {
    return backward;
  }
  const auto& ahead = std::get<TangentialArc<Ball>>(forward);
  const auto& behind = std::get<TangentialArc<Ball>>(backward);
  if (behind.end < 0) {
    return failure(seed, "a curve is closed in one direction only");
  }
  TangentialArc<Ball> arc;
  for (auto piece = behind.pieces.rbegin(); piece != behind.pieces.rend(); ++piece) {
    arc.pieces.push_back({piece->tube, piece->range.reversed()});
  }
  arc.pieces.insert(arc.pieces.end(), ahead.pieces.begin(), ahead.pieces.end());
  arc.start = behind.end;
  arc.end = ahead.end;
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
