#include "filter_trace.h"

#include <algorithm>
#include <cmath>

#include "filter_series.h"

namespace exsect::filter {

namespace {

constexpr double kFirstStep = 0x1p-3;
constexpr double kLeastStep = 0x1p-30;
constexpr double kLongestStep = 0.5;
constexpr double kGoodContraction = 0.2;
constexpr double kWorstContraction = 0.32;
constexpr std::size_t kMostPieces = 2000;

class Tracer {
 public:
  Tracer(const Pair& pair, const std::vector<BoundaryPoint>& points) : pair_(pair), points_(points) {}

  bool run(const Ball& position, int start) {
    position_ = position;
    trace_.start = start;
    trace_.end = -1;
    trace_.pieces.reserve(16);
    while (!finished_) {
      if (trace_.pieces.size() > kMostPieces || !advance()) {
        return false;
      }
    }
    return true;
  }

  Trace take() { return std::move(trace_); }

 private:
  /// The next piece, with smaller steps until it is proved.
  bool advance() {
    const Linearisation at = linearise(expand(pair_.x, position_.middle[0], position_.middle[1]),
                                       expand(pair_.y, position_.middle[2], position_.middle[3]));
    std::size_t axis = steepest(at.tangent);
    int direction = wanted_direction(at.tangent, axis);
    if (direction == 0) {  // turned so much that the last tube does not tell: its own axis, once more
      axis = trace_.pieces.back().tube.axis;
      direction = wanted_direction(at.tangent, axis);
    }
    Vec4 slope;
    for (std::size_t j = 0; j < 4; ++j) {
      slope[j] = at.tangent[j] / at.tangent[axis];
    }
    for (; step_ >= kLeastStep; step_ *= 0.5) {
      Piece& piece = trace_.pieces.emplace_back();
      if (next_tube(slope, axis, direction, piece.tube) && accept(piece, direction)) {
        return true;
      }
      trace_.pieces.pop_back();
    }
    return false;
  }

  /// The sign of the step in the axis that goes on along the curve, 0 if the last tube does not prove it. At
  /// the start of a closed curve along the tangent field; at a boundary point a guess, proved by
  /// `starts_inward`.
  int wanted_direction(const Vec4& tangent, std::size_t axis) const {
    if (trace_.pieces.empty()) {
      if (trace_.start < 0) {
        return tangent[axis] > 0 ? 1 : -1;
      }
      const BoundaryPoint& start = points_[static_cast<std::size_t>(trace_.start)];
      return (tangent[start.parameter] * start.side > 0) == (tangent[axis] > 0) ? -1 : 1;
    }
    const Piece& last = trace_.pieces.back();
    const double along = last.tube.slope[axis];
    if (!(std::fabs(along) > last.tube.slope_error[axis])) {
      return 0;
    }
    return (along > 0) == (last.to > last.from) ? 1 : -1;
  }

  /// A tube whose middle is half a step ahead and that contains the position.
  bool next_tube(const Vec4& slope, std::size_t axis, int direction, Tube& tube) const {
    Vec4 centre = position_.middle;
    for (std::size_t j = 0; j < 4; ++j) {
      centre[j] += 0.5 * direction * step_ * slope[j];
    }
    if (!improve(pair_, centre, axis, 2) || !prepare(pair_, centre, axis, tube)) {
      return false;
    }
    const double reach = 0.51 * step_ + 2 * position_.radius;
    const double width = std::max(2 * largest(residual_bound(pair_, tube, reach)), kLeastHalfwidth);
    if (position_.radius > 0.25 * kEndMargin ||
        !certify(pair_, tube, -reach, reach, {width, width, width, width}) ||
        tube.contraction > kWorstContraction || !contains(tube, position_)) {
      return false;
    }
    bound_derivatives(pair_, tube);
    expand_arc(tube);
    return true;
  }

  bool starts_inward(const Tube& tube, int direction) const {
    const BoundaryPoint& start = points_[static_cast<std::size_t>(trace_.start)];
    const double along = tube.slope[start.parameter];
    return std::fabs(along) > tube.slope_error[start.parameter] && along * direction * start.side < 0;
  }

  /// Decides every boundary point on the tube; ends at the first one ahead, else goes on to the far end.
  bool accept(Piece& piece, int direction) {
    const Tube& tube = piece.tube;
    const bool first = trace_.pieces.size() == 1;
    if (first && trace_.start >= 0 && !starts_inward(tube, direction)) {
      return false;
    }
    const double here = offset(tube, position_);
    int met = -1;
    double met_at = 0;
    double met_radius = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Ball& ball = points_[i].ball;
      if ((first && static_cast<int>(i) == trace_.start) || excludes(tube, ball)) {
        continue;
      }
      const double at = offset(tube, ball);
      const double doubt = 2 * (ball.radius + position_.radius) + 0x1p-48;
      if (direction * (at - here) < -doubt) {
        continue;
      }
      if (direction * (at - here) <= doubt || !contains(tube, ball) ||
          (met >= 0 && std::fabs(at - met_at) <= ball.radius + met_radius + 0x1p-48)) {
        return false;
      }
      if (met < 0 || direction * (at - met_at) < 0) {
        met = static_cast<int>(i);
        met_at = at;
        met_radius = ball.radius;
      }
    }
    piece.from = here;
    if (closing_ && !excludes(tube, *closing_)) {
      const double ahead = direction * (offset(tube, *closing_) - here);
      const double doubt = 2 * (closing_->radius + position_.radius) + 0x1p-48;
      if (ahead >= -doubt) {
        if (ahead <= doubt || met >= 0 || !contains(tube, *closing_)) {
          return false;
        }
        piece.to = offset(tube, *closing_);
        finished_ = true;
        return true;
      }
    }
    if (met >= 0) {
      piece.to = met_at;
      trace_.end = met;
      finished_ = true;
    } else {
      move_on(piece, direction);
    }
    return true;
  }

  static double offset(const Tube& tube, const Ball& ball) {
    return ball.middle[tube.axis] - tube.centre[tube.axis];
  }

  /// To an odd place near the far end, so that pieces of symmetric curves do not end at turning points. A
  /// closed curve starts inside its first piece for the same reason.
  void move_on(Piece& piece, int direction) {
    piece.to = 0.4931 * direction * step_;
    const double fast = std::clamp(kGoodContraction / piece.tube.contraction, 0.5, 2.0);
    position_ = point_at(piece.tube, piece.to);
    if (trace_.start < 0 && trace_.pieces.size() == 1) {
      piece.from += 0.61803 * (piece.to - piece.from);
      closing_ = point_at(piece.tube, piece.from);
    }
    step_ = std::min(fast * step_, kLongestStep);
  }

  const Pair& pair_;
  const std::vector<BoundaryPoint>& points_;
  Trace trace_;
  Ball position_;
  std::optional<Ball> closing_;
  double step_ = kFirstStep;
  bool finished_ = false;
};

}  // namespace

std::optional<Trace> trace_arc(const Pair& pair, const std::vector<BoundaryPoint>& points,
                               std::size_t start) {
  Tracer tracer(pair, points);
  if (!tracer.run(points[start].ball, static_cast<int>(start))) {
    return std::nullopt;
  }
  return tracer.take();
}

std::optional<Trace> trace_loop(const Pair& pair, const std::vector<BoundaryPoint>& points, const Tube& tube,
                                double tau) {
  Tracer tracer(pair, points);
  if (!tracer.run(point_at(tube, tau), -1)) {
    return std::nullopt;
  }
  Trace trace = tracer.take();
  return trace.end < 0 ? std::optional(std::move(trace)) : std::nullopt;
}

}  // namespace exsect::filter
