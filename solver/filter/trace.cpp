#include "filter/trace.h"

#include <algorithm>
#include <cmath>

#include "filter/series.h"
#include "filter/tube_derivatives.h"
#include "filter/tube_newton.h"
#include "trace/steps.h"

namespace exsect::filter {

namespace {

template <class K>
class Tracer {
 public:
  Tracer(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points)
      : pair_(pair), points_(points) {}

  bool run(const BallOf<K>& position, int start) {
    position_ = position;
    trace_.start = start;
    trace_.end = -1;
    trace_.pieces.reserve(16);
    while (!finished_) {
      if (trace_.pieces.size() > kFilterSteps.most_pieces || !advance()) {
        return false;
      }
    }
    return true;
  }

  TraceOf<K> take() { return std::move(trace_); }
  Vec4 position() const { return parameters_of(position_); }

 private:
  /// The next piece, with smaller steps until it is proved.
  bool advance() {
    const Unknowns<K> tangent = tangent_here();
    std::size_t axis = steepest(first_four<K>(tangent));
    int direction = wanted_direction(tangent, axis);
    if (direction == 0) {  // turned so much that the last tube does not tell: its own axis, once more
      axis = trace_.pieces.back().tube.axis;
      direction = wanted_direction(tangent, axis);
    }
    for (; step_ >= kFilterSteps.least; step_ *= 0.5) {
      const Unknowns<K> centre = centre_ahead(tangent, axis, direction);
      PieceOf<K>& piece = trace_.pieces.emplace_back();
      if (next_tube(centre, axis, piece.tube) && accept(piece, direction)) {
        return true;
      }
      trace_.pieces.pop_back();
    }
    return false;
  }

  /// Along the curve, one way or the other.
  Unknowns<K> tangent_here() const {
    if (!trace_.pieces.empty()) {
      return arc_slope(trace_.pieces.back().tube, trace_.pieces.back().range.to());
    }
    return linearise(pair_, position_.middle).tangent;
  }

  /// About the point of the curve half a step ahead.
  Unknowns<K> centre_ahead(const Unknowns<K>& tangent, std::size_t axis, int direction) const {
    const double ahead = 0.5 * direction * step_;
    Unknowns<K> centre = position_.middle;
    if (trace_.pieces.empty()) {
      for (std::size_t j = 0; j < K::unknowns; ++j) {
        centre[j] += ahead * (tangent[j] / tangent[axis]);
      }
      return centre;
    }
    const PieceOf<K>& last = trace_.pieces.back();
    Unknowns<K> next = place_at(last.tube, arc_offset(last.tube, last.range.to() + ahead / tangent[axis]));
    next[axis] = centre[axis] + ahead;
    return next;
  }

  /// The sign of the step in the axis that goes on along the curve, 0 if the last tube does not prove it. At
  /// the start of a closed curve along the tangent field; at a boundary point a guess, proved by
  /// `starts_inward`.
  int wanted_direction(const Unknowns<K>& tangent, std::size_t axis) const {
    if (trace_.pieces.empty()) {
      if (trace_.start < 0) {
        return tangent[axis] > 0 ? 1 : -1;
      }
      const BoundaryPointOf<K>& start = points_[static_cast<std::size_t>(trace_.start)];
      return (tangent[start.parameter] * start.side > 0) == (tangent[axis] > 0) ? -1 : 1;
    }
    const PieceOf<K>& last = trace_.pieces.back();
    const double along = last.tube.slope[axis];
    if (!(std::fabs(along) > last.tube.slope_error[axis])) {
      return 0;
    }
    return along > 0 ? last.range.direction() : -last.range.direction();
  }

  /// A tube around the centre, half a step ahead, that contains the position.
  bool next_tube(Unknowns<K> centre, std::size_t axis, TubeOf<K>& tube) const {
    if (!improve(pair_, centre, axis, 3) || !prepare(pair_, centre, axis, tube)) {
      return false;
    }
    const double reach = 0.51 * step_ + 2 * position_.radius;
    const Row<K> residual = residual_bound(pair_, tube, reach);
    if (position_.radius > 0.25 * kEndMargin<K::width> ||
        !certify(pair_, tube, -reach, reach, halfwidths<K>(residual, kLeastHalfwidth<K::width>), residual) ||
        tube.contraction > kFilterSteps.worst || !contains(tube, position_)) {
      return false;
    }
    bound_derivatives(pair_, tube);
    expand_arc(tube);
    return true;
  }

  bool starts_inward(const TubeOf<K>& tube, int direction) const {
    const BoundaryPointOf<K>& start = points_[static_cast<std::size_t>(trace_.start)];
    const double along = tube.slope[start.parameter];
    return std::fabs(along) > tube.slope_error[start.parameter] && along * direction * start.side < 0;
  }

  /// Decides every boundary point on the tube; ends at the first one ahead, else goes on to the far end.
  bool accept(PieceOf<K>& piece, int direction) {
    const TubeOf<K>& tube = piece.tube;
    const bool first = trace_.pieces.size() == 1;
    if (first && trace_.start >= 0 && !starts_inward(tube, direction)) {
      return false;
    }
    const double here = offset(tube, position_);
    int met = -1;
    double met_at = 0;
    double met_radius = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const BallOf<K>& ball = points_[i].ball;
      if ((first && static_cast<int>(i) == trace_.start) || excludes(tube, ball)) {
        continue;
      }
      const double at = offset(tube, ball);
      const double doubt = 2 * (ball.radius + position_.radius) + kPlacing;
      if (direction * (at - here) < -doubt) {
        continue;
      }
      if (direction * (at - here) <= doubt || !contains(tube, ball) ||
          (met >= 0 && std::fabs(at - met_at) <= ball.radius + met_radius + kPlacing)) {
        return false;
      }
      if (met < 0 || direction * (at - met_at) < 0) {
        met = static_cast<int>(i);
        met_at = at;
        met_radius = ball.radius;
      }
    }
    if (closing_ && !excludes(tube, *closing_)) {
      const double ahead = direction * (offset(tube, *closing_) - here);
      const double doubt = 2 * (closing_->radius + position_.radius) + kPlacing;
      if (ahead >= -doubt) {
        if (ahead <= doubt || met >= 0 || !contains(tube, *closing_)) {
          return false;
        }
        finished_ = use(piece, here, offset(tube, *closing_), doubt, direction);
        return finished_;
      }
    }
    if (met >= 0) {
      trace_.end = met;
      finished_ = use(piece, here, met_at, position_.radius + met_radius, direction);
      return finished_;
    }
    return move_on(piece, here, direction);
  }

  /// The part of the piece's tube between two offsets, the difference of which is known up to `doubt`; false
  /// if it is not certainly in this direction.
  static bool use(PieceOf<K>& piece, double from, double to, double doubt, int direction) {
    const auto range = PieceRange::between(from, to, 0.5 * doubt);
    if (!range || range->direction() != direction) {
      return false;
    }
    piece.range = *range;
    return true;
  }

  static double offset(const TubeOf<K>& tube, const BallOf<K>& ball) {
    return ball.middle[tube.axis] - tube.centre[tube.axis];
  }

  /// To an odd place near the far end, so that pieces of symmetric curves do not end at turning points. A
  /// closed curve starts inside its first piece for the same reason.
  bool move_on(PieceOf<K>& piece, double here, int direction) {
    const double to = 0.4931 * direction * step_;
    const bool starts_loop = trace_.start < 0 && trace_.pieces.size() == 1;
    const double from = starts_loop ? here + 0.61803 * (to - here) : here;
    if (!use(piece, from, to, position_.radius, direction)) {
      return false;
    }
    const double fast = std::clamp(kFilterSteps.good / piece.tube.contraction, 0.5, 2.0);
    position_ = point_at(piece.tube, to);
    if (starts_loop) {
      closing_ = point_at(piece.tube, from);
    }
    step_ = std::min(fast * step_, kFilterSteps.longest);
    return true;
  }

  const PairOf<K>& pair_;
  const std::vector<BoundaryPointOf<K>>& points_;
  TraceOf<K> trace_;
  BallOf<K> position_;
  std::optional<BallOf<K>> closing_;
  double step_ = kFilterSteps.first;
  bool finished_ = false;
};

}  // namespace

template <class K>
std::optional<TraceOf<K>> trace_arc(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
                                    std::size_t start, Vec4* stuck) {
  Tracer<K> tracer(pair, points);
  if (!tracer.run(points[start].ball, static_cast<int>(start))) {
    if (stuck != nullptr) {
      *stuck = tracer.position();
    }
    return std::nullopt;
  }
  return tracer.take();
}

template <class K>
std::optional<TraceOf<K>> trace_loop(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
                                     const TubeOf<K>& tube, double tau) {
  Tracer<K> tracer(pair, points);
  if (!tracer.run(point_at(tube, tau), -1)) {
    return std::nullopt;
  }
  TraceOf<K> trace = tracer.take();
  return trace.end < 0 ? std::optional(std::move(trace)) : std::nullopt;
}

#define EXSECT_INSTANTIATE(K)                                                                                \
  template std::optional<TraceOf<K>> trace_arc<K>(const PairOf<K>&, const std::vector<BoundaryPointOf<K>>&,  \
                                                  std::size_t, Vec4*);                                       \
  template std::optional<TraceOf<K>> trace_loop<K>(const PairOf<K>&, const std::vector<BoundaryPointOf<K>>&, \
                                                   const TubeOf<K>&, double);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
