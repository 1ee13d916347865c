#include "filter/trace.h"

#include <algorithm>
#include <cmath>

#include "filter/series.h"

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
  const Vec4& position() const { return position_.middle; }

 private:
  /// The next piece, with smaller steps until it is proved.
  bool advance() {
    const Vec4 tangent = tangent_here();
    std::size_t axis = steepest(tangent);
    int direction = wanted_direction(tangent, axis);
    if (direction == 0) {  // turned so much that the last tube does not tell: its own axis, once more
      axis = trace_.pieces.back().tube.axis;
      direction = wanted_direction(tangent, axis);
    }
    for (; step_ >= kLeastStep; step_ *= 0.5) {
      const Vec4 centre = centre_ahead(tangent, axis, direction);
      Piece& piece = trace_.pieces.emplace_back();
      if (next_tube(centre, axis, piece.tube) && accept(piece, direction)) {
        return true;
      }
      trace_.pieces.pop_back();
    }
    return false;
  }

  /// Along the curve, one way or the other.
  Vec4 tangent_here() const {
    if (!trace_.pieces.empty()) {
      return arc_slope(trace_.pieces.back().tube, trace_.pieces.back().range.to());
    }
    const Vec4& p = position_.middle;
    return linearise(expand(pair_.x, p[0], p[1]), expand(pair_.y, p[2], p[3])).tangent;
  }

  /// About the point of the curve half a step ahead.
  Vec4 centre_ahead(const Vec4& tangent, std::size_t axis, int direction) const {
    const double ahead = 0.5 * direction * step_;
    Vec4 centre = position_.middle;
    if (trace_.pieces.empty()) {
      for (std::size_t j = 0; j < 4; ++j) {
        centre[j] += ahead * (tangent[j] / tangent[axis]);
      }
      return centre;
    }
    const Piece& last = trace_.pieces.back();
    const Vec4 offset = arc_offset(last.tube, last.range.to() + ahead / tangent[axis]);
    for (std::size_t j = 0; j < 4; ++j) {
      centre[j] = j == axis ? centre[j] + ahead : last.tube.centre[j] + offset[j];
    }
    return centre;
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
    return along > 0 ? last.range.direction() : -last.range.direction();
  }

  /// A tube around the centre, half a step ahead, that contains the position.
  bool next_tube(Vec4 centre, std::size_t axis, Tube& tube) const {
    if (!improve(pair_, centre, axis, 3) || !prepare(pair_, centre, axis, tube)) {
      return false;
    }
    const double reach = 0.51 * step_ + 2 * position_.radius;
    const Vec3 residual = residual_bound(pair_, tube, reach);
    const double width = std::max(2 * largest(residual), kLeastHalfwidth);
    if (position_.radius > 0.25 * kEndMargin ||
        !certify(pair_, tube, -reach, reach, {width, width, width, width}, residual) ||
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
  static bool use(Piece& piece, double from, double to, double doubt, int direction) {
    const auto range = PieceRange::between(from, to, 0.5 * doubt);
    if (!range || range->direction() != direction) {
      return false;
    }
    piece.range = *range;
    return true;
  }

  static double offset(const Tube& tube, const Ball& ball) {
    return ball.middle[tube.axis] - tube.centre[tube.axis];
  }

  /// To an odd place near the far end, so that pieces of symmetric curves do not end at turning points. A
  /// closed curve starts inside its first piece for the same reason.
  bool move_on(Piece& piece, double here, int direction) {
    const double to = 0.4931 * direction * step_;
    const bool starts_loop = trace_.start < 0 && trace_.pieces.size() == 1;
    const double from = starts_loop ? here + 0.61803 * (to - here) : here;
    if (!use(piece, from, to, position_.radius, direction)) {
      return false;
    }
    const double fast = std::clamp(kGoodContraction / piece.tube.contraction, 0.5, 2.0);
    position_ = point_at(piece.tube, to);
    if (starts_loop) {
      closing_ = point_at(piece.tube, from);
    }
    step_ = std::min(fast * step_, kLongestStep);
    return true;
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

std::optional<Trace> trace_arc(const Pair& pair, const std::vector<BoundaryPoint>& points, std::size_t start,
                               Vec4* stuck) {
  Tracer tracer(pair, points);
  if (!tracer.run(points[start].ball, static_cast<int>(start))) {
    if (stuck != nullptr) {
      *stuck = tracer.position();
    }
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
