#include "trace/tracer.h"

#include <algorithm>
#include <cmath>

#include "trace/preconditioned_newton.h"
#include "trace/tube_points.h"
#include "trace/tube_prediction.h"

namespace exsect {

namespace {

constexpr double kFirstStep = 0.1;
constexpr double kGoodContraction = 0.25;  // steps are chosen to end near this value
constexpr double kWorstContraction = 0.5;
constexpr double kOverlap = 1.02;
/// A tube that ends at a point is longer than one whose centre the point is, by about this factor on the way
/// out of a narrow place, and on the way in.
constexpr double kAhead = 4;
constexpr double kAheadInwards = 1.4;
/// Where one as short as this cannot be proved, the numbers are too rough.
constexpr double kBehind = 0.25;
/// The contraction grows with the reach's power m + 1, m the degree of the line: the numbers here are made
/// for the degree 3.
template <class Ball>
constexpr double kDegreeRatio = kLineDegree<Ball> == 3 ? 1 : kLineDegree<Ball> + 1;
/// Room from which steps were too cautious.
template <class Ball>
constexpr double kMuchRoom = kLineDegree<Ball> == 3 ? 0x1p8 : 4;
/// Steps grow or shrink as the last ones did, and more boldly after one that was proved at once.
constexpr double kLeastGrowth = 0.4;
constexpr double kMostGrowth = 2;
constexpr double kMoreGrowth = 1.4;
/// Bound of |X''| step^2: where it is larger the bound is a bad one, and chords would have to be very short.
constexpr double kWorstBend = 4;
constexpr int kMostPieces = 200000;
/// Radius of the points where tubes are joined, by the least half width.
constexpr double kEndRadius = 0x1p-12;

template <class Ball>
constexpr double kLeastStep = 0x1p-40;
template <>
inline constexpr double kLeastStep<DoubleDoubleBall> = 0x1p-70;
template <long Bits>
inline constexpr double kLeastStep<ArbBall<Bits>> = Bits > 256 ? 0x1p-450 : 0x1p-110;

template <class Ball>
constexpr int kNewtonSteps = 2;
template <>
inline constexpr int kNewtonSteps<DoubleDoubleBall> = 3;
template <long Bits>
inline constexpr int kNewtonSteps<ArbBall<Bits>> = Bits > 256 ? 6 : 4;

template <class Ball>
TraceFailure failure(const BallPoint<Ball>& at, const char* why) {
  return {{at[0].approximation(), at[1].approximation(), at[2].approximation(), at[3].approximation()}, why};
}

template <class Ball>
double largest_radius(const BallPoint<Ball>& box) {
  return std::max({box[0].radius(), box[1].radius(), box[2].radius(), box[3].radius()});
}

template <class Ball>
double narrowest(const Tube<Ball>& tube) {
  double least = 1;
  for (const std::size_t j : other_axes(tube.axis)) {
    least = std::min(least, tube.halfwidth[j]);
  }
  return least;
}

/// The state of a trace: a curve point in a small box, reached in the direction sign * T.
template <class Ball>
class Tracer {
 public:
  Tracer(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks, int sign, const StopRequest& stop)
      : system_(system), landmarks_(landmarks), sign_(sign), stop_(stop) {}

  std::variant<Trace<Ball>, TraceFailure> run(const BallPoint<Ball>& start, int start_landmark) {
    position_ = start;
    trace_.start = start_landmark;
    trace_.ends[0] = start;
    while (trace_.pieces.size() < kMostPieces) {
      if (stop_ && stop_()) {
        return failure(position_, "the work cap was reached");
      }
      if (!advance()) {
        return failure(position_, failure_);
      }
      if (finished_) {
        return std::move(trace_);
      }
    }
    return failure(position_, "too many steps along one curve");
  }

 private:
  /// One tube from the current position; sets finished_ at a landmark or where a closed curve closes.
  bool advance() {
    const BallPoint<Ball> tangent = Expansion<Ball>(system_, position_).tangent();
    const std::size_t axis = steepest_axis(tangent);
    const int known = tangent[axis].certain_sign();
    if (known == 0) {
      failure_ = "the tangent of the intersection curve vanishes or cannot be told from zero";
      return false;
    }
    direction_ = sign_ * known;
    const double planned = step_;
    const double before = growth_;
    double hopeless = 0;
    for (bool first = true; step_ >= kLeastStep<Ball>; first = false) {
      const bool by_tangent = first && !tangent_misses_;
      const auto tube = next_tube(tangent, axis, by_tangent);
      growth_ = first                   ? std::min(kMostGrowth, kMoreGrowth * before)
                : trace_.pieces.empty() ? 1
                                        : std::max(kLeastGrowth, before * step_ / planned);
      if (tube && accept(*tube)) {
        tangent_misses_ = !by_tangent && kLineDegree<Ball> > 3;
        return true;
      }
      if (!tube && step_ < hopeless) {
        break;
      }
      step_ *= 0.6;
      if (!tube && first) {
        const double reach = largest_reach(system_, position_, axis, kLeastStep<Ball>, step_,
                                           4 * largest_radius(position_), kWorstContraction);
        step_ = std::min(step_, (before < 1 ? kAheadInwards : kAhead) * reach);
        hopeless = kBehind * reach;
      }
    }
    failure_ = "the steps along the curve become too small: a singular or nearly singular point";
    return false;
  }

  /// Half a step ahead on the tangent.
  std::optional<BallPoint<Ball>> on_tangent(const BallPoint<Ball>& tangent, std::size_t axis) const {
    const auto reciprocal = approximate_reciprocal(tangent[axis]);
    if (!reciprocal) {
      return std::nullopt;
    }
    BallPoint<Ball> guess;
    for (std::size_t j = 0; j < 4; ++j) {
      const Ball slope = j == axis ? Ball(1) : tangent[j] * *reciprocal;
      guess[j] = (position_[j] + Ball(0.5 * direction_ * step_) * slope).midpoint();
    }
    return guess;
  }

  /// The tube of the next step, about a point that is found from the tangent, or with more work.
  std::optional<Tube<Ball>> next_tube(const BallPoint<Ball>& tangent, std::size_t axis,
                                      bool by_tangent) const {
    const auto guess = by_tangent ? on_tangent(tangent, axis)
                                  : predicted(system_, position_, axis, 0.5 * direction_ * step_);
    const auto centre = guess ? newton_corrected(system_, *guess, axis, kNewtonSteps<Ball>)
                              : std::optional<BallPoint<Ball>>();
    if (!centre) {
      return std::nullopt;
    }
    const double radius = largest_radius(position_);
    auto tube = certify_tube(system_, *centre, axis, 0.5 * kOverlap * step_ + 2 * radius, 4 * radius);
    if (!tube || tube->contraction > kWorstContraction ||
        tube->space_second_derivative * step_ * step_ > kWorstBend || !contains(*tube, position_)) {
      return std::nullopt;
    }
    return tube;
  }

  /// Decides every landmark on the tube; ends at the first one ahead, else moves on to the far end.
  bool accept(const Tube<Ball>& tube) {
    const Ball here = offset(tube, position_);
    int met = -1;
    Ball met_at;
    for (int i = 0; i < static_cast<int>(landmarks_.size()); ++i) {
      const BallPoint<Ball>& box = landmarks_[static_cast<std::size_t>(i)];
      if ((trace_.pieces.empty() && i == trace_.start) || excludes(tube, box)) {
        continue;
      }
      const Ball at = offset(tube, box);
      const int ahead = direction_ * (at - here).certain_sign();
      if (ahead < 0) {
        continue;
      }
      if (ahead == 0 || !contains(tube, box)) {
        return false;
      }
      const int order = met < 0 ? -1 : direction_ * (at - met_at).certain_sign();
      if (order == 0) {
        return false;
      }
      if (order < 0) {
        met = i;
        met_at = at;
      }
    }
    const bool closes = closing_ && contains(tube, *closing_) &&
                        direction_ * (offset(tube, *closing_) - here).certain_sign() > 0;
    if (closes && met >= 0) {
      return false;
    }
    if (met < 0 && !closes) {
      return move_to_end(tube, here);
    }
    if (!add_piece(tube, here, closes ? offset(tube, *closing_) : met_at)) {
      return false;
    }
    trace_.end = met;
    if (met >= 0) {
      trace_.ends[1] = landmarks_[static_cast<std::size_t>(met)];
    }
    finished_ = true;
    return true;
  }

  /// Of the tube, between two offsets; false if the second one is not certainly ahead of the first one.
  bool add_piece(const Tube<Ball>& tube, const Ball& from, const Ball& to) {
    const auto range = PieceRange::between(from, to);
    if (!range || range->direction() != direction_) {
      return false;
    }
    trace_.pieces.push_back({tube, *range});
    return true;
  }

  bool move_to_end(const Tube<Ball>& tube, const Ball& here) {
    BallPoint<Ball> end;
    double to = 0;
    for (const double fraction : {1.0, 0.91, 0.83, 0.76}) {
      to = 0.5 * direction_ * step_ * fraction;
      end = point_at(tube, to, kEndRadius * narrowest(tube));
      const BallPoint<Ball> t = Expansion<Ball>(system_, end).tangent();
      if (std::all_of(t.begin(), t.end(), [](const Ball& c) { return c.certain_sign() != 0; })) {
        break;
      }
    }
    for (const Ball& c : end) {
      if (c.is_negative() || (c - Ball(1)).is_positive()) {
        return false;  // left the domain without meeting a boundary point: take smaller steps
      }
    }
    const bool starts_loop = trace_.start < 0 && trace_.pieces.empty();
    const Ball from = starts_loop ? Ball(inside_first_piece(here, to)) : here;
    if (!add_piece(tube, from, Ball(to))) {
      return false;
    }
    if (starts_loop) {
      closing_ = point_at(tube, trace_.pieces.front().range.from());
    }
    position_ = end;
    const double room = std::pow(kGoodContraction / tube.contraction, 1 / kDegreeRatio<Ball>);
    const double growth = room > kMuchRoom<Ball> ? kMostGrowth : growth_;
    step_ = std::min(growth * step_, step_ * std::max(0.5, room));
    step_ = std::min(step_, 0.5);
    return true;
  }

  /// A closed curve starts at an odd place of its first tube, so that the seed's special position (a sample u
  /// where symmetric curves turn) is never a joint.
  static double inside_first_piece(const Ball& here, double to) {
    return here.approximation() + 0.61803 * (to - here.approximation());
  }

  const PairSystem<Ball>& system_;
  const Landmarks<Ball>& landmarks_;
  int sign_;
  const StopRequest& stop_;
  Trace<Ball> trace_;
  BallPoint<Ball> position_;
  std::optional<BallPoint<Ball>> closing_;
  double step_ = kFirstStep;
  double growth_ = kMostGrowth;
  int direction_ = 1;
  bool tangent_misses_ = false;  // the curve, so widely that Newton's method does not find it
  bool finished_ = false;
  const char* failure_ = "";
};

}  // namespace

template <class Ball>
std::variant<Trace<Ball>, TraceFailure> trace_arc(const PairSystem<Ball>& system,
                                                  const Landmarks<Ball>& landmarks, int start, int sign,
                                                  const StopRequest& stop) {
  return Tracer<Ball>(system, landmarks, sign, stop).run(landmarks[static_cast<std::size_t>(start)], start);
}

template <class Ball>
std::variant<Trace<Ball>, TraceFailure> trace_loop(const PairSystem<Ball>& system,
                                                   const Landmarks<Ball>& landmarks,
                                                   const BallPoint<Ball>& seed, const StopRequest& stop) {
  auto result = Tracer<Ball>(system, landmarks, 1, stop).run(seed, -1);
  if (const auto* trace = std::get_if<Trace<Ball>>(&result); trace && trace->end >= 0) {
    return failure(seed, "a curve thought to be closed met a boundary point");
  }
  return result;
}

template <class Ball>
bool passes_through(const Trace<Ball>& trace, const BallPoint<Ball>& box) {
  const auto lies_behind = [&](const Piece<Ball>& piece, const BallPoint<Ball>& end, int inwards) {
    return inwards * (offset(piece.tube, box) - offset(piece.tube, end)).certain_sign() < 0;
  };
  for (std::size_t i = 0; i < trace.pieces.size(); ++i) {
    const Piece<Ball>& piece = trace.pieces[i];
    const int direction = piece.range.direction();
    const bool open = trace.start >= 0;  // behind its ends the curve is another one, or outside
    if (contains(piece.tube, box) && !(open && i == 0 && lies_behind(piece, trace.ends[0], direction)) &&
        !(open && i + 1 == trace.pieces.size() && lies_behind(piece, trace.ends[1], -direction))) {
      return true;
    }
  }
  return false;
}

#define EXSECT_INSTANTIATE_TRACER(Ball)                                                             \
  template std::variant<Trace<Ball>, TraceFailure> trace_arc(                                       \
      const PairSystem<Ball>&, const Landmarks<Ball>&, int, int, const StopRequest&);               \
  template std::variant<Trace<Ball>, TraceFailure> trace_loop(                                      \
      const PairSystem<Ball>&, const Landmarks<Ball>&, const BallPoint<Ball>&, const StopRequest&); \
  template bool passes_through(const Trace<Ball>&, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_TRACER(DoubleBall)
EXSECT_INSTANTIATE_TRACER(DoubleDoubleBall)
EXSECT_INSTANTIATE_TRACER(ArbBall<256>)
EXSECT_INSTANTIATE_TRACER(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_TRACER

}  // namespace exsect
