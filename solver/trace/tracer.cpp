#include "trace/tracer.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "trace/preconditioned_newton.h"
#include "trace/tube_points.h"
#include "trace/tube_prediction.h"
#include "trace/tube_tracer.h"

namespace exsect {

namespace {

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
/// Radius of the points where tubes are joined, by the least half width.
constexpr double kEndRadius = 0x1p-12;

template <class Ball>
constexpr double kLeastStep = LeastStep<Ball>::of(kPairSteps);

template <class Ball>
constexpr int kNewtonSteps = 2;
template <>
inline constexpr int kNewtonSteps<DoubleDoubleBall> = 3;
template <long Bits>
inline constexpr int kNewtonSteps<ArbBall<Bits>> = Bits > 256 ? 6 : 4;

template <class Ball>
double narrowest(const Tube<Ball>& tube) {
  double least = 1;
  for (const std::size_t j : other_axes(tube.axis)) {
    least = std::min(least, tube.halfwidth[j]);
  }
  return least;
}

/// The tubes along sign * T, T the tangent field (tube_tracer.h).
template <class Ball>
class PairCourse {
 public:
  using Box = BallPoint<Ball>;
  using Offset = Ball;
  using Landmarks = exsect::Landmarks<Ball>;
  using Tube = exsect::Tube<Ball>;
  using Trace = exsect::Trace<Ball>;
  static constexpr Steps steps = kPairSteps;
  static constexpr const char* too_small =
      "the steps along the curve become too small: a singular or nearly singular point";
  static constexpr bool starts_inside = true;

  PairCourse(const PairSystem<Ball>& system, int sign) : system_(system), sign_(sign) {}

  const char* set_out(const Trace& trace, const BallPoint<Ball>& position) {
    position_ = position;
    tangent_ = Expansion<Ball>(system_, position).tangent();
    axis_ = steepest_axis(tangent_);
    const int known = tangent_[axis_].certain_sign();
    direction_ = sign_ * known;
    planned_ = step_;
    before_ = growth_;
    hopeless_ = 0;
    given_up_ = false;
    first_ = true;
    first_piece_ = trace.pieces.empty();
    return known != 0 ? nullptr
                      : "the tangent of the intersection curve vanishes or cannot be told from zero";
  }

  bool may_try() const { return !given_up_ && step_ >= kLeastStep<Ball>; }

  /// `had`: there was a tube, but it did not decide what it meets.
  void shorter(bool had) {
    given_up_ = !had && step_ < hopeless_;
    step_ *= 0.6;
    if (!had && first_) {
      const double reach = largest_reach(system_, position_, axis_, kLeastStep<Ball>, step_,
                                         4 * largest_radius(position_), steps.worst);
      step_ = std::min(step_, (before_ < 1 ? kAheadInwards : kAhead) * reach);
      hopeless_ = kBehind * reach;
    }
    first_ = false;
  }

  /// About a point that is found from the tangent, or with more work.
  std::optional<Tube> next_tube() {
    by_tangent_ = first_ && !tangent_misses_;
    growth_ = first_         ? std::min(kMostGrowth, kMoreGrowth * before_)
              : first_piece_ ? 1
                             : std::max(kLeastGrowth, before_ * step_ / planned_);
    const auto guess =
        by_tangent_ ? on_tangent() : predicted(system_, position_, axis_, 0.5 * direction_ * step_);
    const auto centre = guess ? newton_corrected(system_, *guess, axis_, kNewtonSteps<Ball>)
                              : std::optional<BallPoint<Ball>>();
    if (!centre) {
      return std::nullopt;
    }
    const double radius = largest_radius(position_);
    auto tube = certify_tube(system_, *centre, axis_, 0.5 * kOverlap * step_ + 2 * radius, 4 * radius);
    if (!tube || tube->contraction > steps.worst ||
        tube->space_second_derivative * step_ * step_ > kWorstBend || !contains(*tube, position_)) {
      return std::nullopt;
    }
    return tube;
  }

  int direction() const { return direction_; }

  /// Near the far end, if possible where no component of the tangent may be zero: a joint at a turning point
  /// would hide it.
  std::pair<double, BallPoint<Ball>> joint(const Tube& tube) const {
    std::pair<double, BallPoint<Ball>> result;
    auto& [to, end] = result;
    for (const double fraction : {1.0, 0.91, 0.83, 0.76}) {
      to = 0.5 * direction_ * step_ * fraction;
      end = point_at(tube, to, kEndRadius * narrowest(tube));
      const BallPoint<Ball> t = Expansion<Ball>(system_, end).tangent();
      if (std::all_of(t.begin(), t.end(), [](const Ball& c) { return c.certain_sign() != 0; })) {
        break;
      }
    }
    return result;
  }

  void taken(const Tube& tube) {
    tangent_misses_ = !by_tangent_ && kLineDegree<Ball> > 3;
    const double room = std::pow(steps.good / tube.contraction, 1 / kDegreeRatio<Ball>);
    const double growth = room > kMuchRoom<Ball> ? kMostGrowth : growth_;
    step_ = std::min(growth * step_, step_ * std::max(0.5, room));
    step_ = std::min(step_, steps.longest);
  }

 private:
  /// Half a step ahead on the tangent.
  std::optional<BallPoint<Ball>> on_tangent() const {
    const auto reciprocal = approximate_reciprocal(tangent_[axis_]);
    if (!reciprocal) {
      return std::nullopt;
    }
    BallPoint<Ball> guess;
    for (std::size_t j = 0; j < 4; ++j) {
      const Ball slope = j == axis_ ? Ball(1) : tangent_[j] * *reciprocal;
      guess[j] = (position_[j] + Ball(0.5 * direction_ * step_) * slope).midpoint();
    }
    return guess;
  }

  const PairSystem<Ball>& system_;
  int sign_;
  BallPoint<Ball> position_;
  BallPoint<Ball> tangent_;
  std::size_t axis_ = 0;
  int direction_ = 1;
  double step_ = steps.first;
  double growth_ = kMostGrowth;
  double planned_ = 0;   // the first of the steps that are tried
  double before_ = 0;    // the growth before it
  double hopeless_ = 0;  // a shorter step without a tube is the last one
  bool given_up_ = false;
  bool first_ = true;
  bool first_piece_ = true;
  bool by_tangent_ = true;
  bool tangent_misses_ = false;  // the curve, so widely that Newton's method does not find it
};

}  // namespace

template <class Ball>
std::variant<Trace<Ball>, TraceFailure> trace_arc(const PairSystem<Ball>& system,
                                                  const Landmarks<Ball>& landmarks, int start, int sign,
                                                  const StopRequest& stop) {
  return TubeTracer<PairCourse<Ball>>({system, sign}, landmarks, stop)
      .run(landmarks[static_cast<std::size_t>(start)], start);
}

template <class Ball>
std::variant<Trace<Ball>, TraceFailure> trace_loop(const PairSystem<Ball>& system,
                                                   const Landmarks<Ball>& landmarks,
                                                   const BallPoint<Ball>& seed, const StopRequest& stop) {
  auto result = TubeTracer<PairCourse<Ball>>({system, 1}, landmarks, stop).run(seed, -1);
  if (const auto* trace = std::get_if<Trace<Ball>>(&result); trace && trace->end >= 0) {
    return trace_failure(seed, "a curve thought to be closed met a boundary point");
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
