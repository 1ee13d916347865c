#include "filter/trace.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filter/series.h"
#include "filter/tube_derivatives.h"
#include "filter/tube_newton.h"
#include "filter/tube_offset.h"
#include "trace/tube_tracer.h"

namespace exsect::filter {

namespace {

/// The tubes of a curve (trace/tube_tracer.h).
template <class K>
class FilterCourse {
 public:
  using Box = BallOf<K>;
  using Offset = TubeOffset;
  using Tube = TubeOf<K>;
  using Trace = TraceOf<K>;
  using Landmarks = std::vector<BoundaryPointOf<K>>;
  static constexpr Steps steps = kFilterSteps;
  static constexpr const char* too_small = "the steps along the curve become too small for doubles";
  static constexpr bool starts_inside = true;

  /// From the boundary point, or along a closed curve if that is null.
  FilterCourse(const PairOf<K>& pair, const BoundaryPointOf<K>* start) : pair_(pair), start_(start) {}

  const char* set_out(const TraceOf<K>& trace, const BallOf<K>& position) {
    last_ = trace.pieces.empty() ? nullptr : &trace.pieces.back();
    position_ = position;
    tangent_ = last_ != nullptr ? arc_slope(last_->tube, last_->range.to())
                                : linearise(pair_, position_.middle).tangent;
    axis_ = steepest(first_four<K>(tangent_));
    direction_ = wanted_direction();
    if (direction_ == 0) {  // turned so much that the last tube does not tell: its own axis, once more
      axis_ = last_->tube.axis;
      direction_ = wanted_direction();
    }
    return direction_ != 0 ? nullptr : "the last tube does not tell the direction";
  }

  bool may_try() const { return step_ >= steps.least; }
  void shorter(bool /*had*/) { step_ *= 0.5; }

  /// A tube around a point half a step ahead, that contains the position.
  std::optional<TubeOf<K>> next_tube() const {
    std::optional<TubeOf<K>> result(std::in_place);
    TubeOf<K>& tube = *result;
    Unknowns<K> centre = centre_ahead();
    if (!improve(pair_, centre, axis_, 3) || !prepare(pair_, centre, axis_, tube)) return std::nullopt;
    const double reach = 0.51 * step_ + 2 * position_.radius;
    const Row<K> residual = residual_bound(pair_, tube, reach);
    if (position_.radius > 0.25 * kEndMargin<K::width> ||
        !certify(pair_, tube, -reach, reach, halfwidths<K>(residual, kLeastHalfwidth<K::width>), residual) ||
        tube.contraction > steps.worst || !contains(tube, position_)) {
      return std::nullopt;
    }
    bound_derivatives(pair_, tube);
    expand_arc(tube);
    if (last_ == nullptr && start_ != nullptr && !starts_inward(tube)) return std::nullopt;
    return result;
  }

  int direction() const { return direction_; }

  /// An odd place near the far end, so that pieces of symmetric curves do not end at turning points.
  std::pair<double, BallOf<K>> joint(const TubeOf<K>& tube) const {
    const double to = 0.4931 * direction_ * step_;
    return {to, point_at(tube, to)};
  }

  void taken(const TubeOf<K>& tube) {
    step_ = std::min(std::clamp(steps.good / tube.contraction, 0.5, 2.0) * step_, steps.longest);
  }

 private:
  /// About the point of the curve half a step ahead.
  Unknowns<K> centre_ahead() const {
    const double ahead = 0.5 * direction_ * step_;
    Unknowns<K> centre = position_.middle;
    if (last_ == nullptr) {
      for (std::size_t j = 0; j < K::unknowns; ++j) centre[j] += ahead * (tangent_[j] / tangent_[axis_]);
      return centre;
    }
    Unknowns<K> next =
        place_at(last_->tube, arc_offset(last_->tube, last_->range.to() + ahead / tangent_[axis_]));
    next[axis_] = centre[axis_] + ahead;
    return next;
  }

  /// The sign of the step in the axis that goes on along the curve, 0 if the last tube does not prove it. At
  /// the start of a closed curve along the tangent field; at a boundary point a guess, proved by
  /// `starts_inward`.
  int wanted_direction() const {
    if (last_ == nullptr) {
      if (start_ == nullptr) return tangent_[axis_] > 0 ? 1 : -1;
      return (tangent_[start_->parameter] * start_->side > 0) == (tangent_[axis_] > 0) ? -1 : 1;
    }
    const double along = last_->tube.slope[axis_];
    if (!(std::fabs(along) > last_->tube.slope_error[axis_])) return 0;
    return along > 0 ? last_->range.direction() : -last_->range.direction();
  }

  bool starts_inward(const TubeOf<K>& tube) const {
    const double along = tube.slope[start_->parameter];
    return std::fabs(along) > tube.slope_error[start_->parameter] && along * direction_ * start_->side < 0;
  }

  const PairOf<K>& pair_;
  const BoundaryPointOf<K>* start_;
  const PieceOf<K>* last_ = nullptr;
  BallOf<K> position_;
  Unknowns<K> tangent_;
  std::size_t axis_ = 0;
  int direction_ = 1;
  double step_ = steps.first;
};

const StopRequest kNeverStopped;

}  // namespace

template <class K>
std::optional<TraceOf<K>> trace_arc(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
                                    std::size_t start, Vec4* stuck) {
  auto trace = TubeTracer<FilterCourse<K>>({pair, &points[start]}, points, kNeverStopped)
                   .run(points[start].ball, static_cast<int>(start));
  if (auto* found = std::get_if<TraceOf<K>>(&trace)) return std::move(*found);
  if (stuck != nullptr) *stuck = std::get<TraceFailure>(trace).where;
  return std::nullopt;
}

template <class K>
std::optional<TraceOf<K>> trace_loop(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
                                     const TubeOf<K>& tube, double tau) {
  auto trace =
      TubeTracer<FilterCourse<K>>({pair, nullptr}, points, kNeverStopped).run(point_at(tube, tau), -1);
  auto* found = std::get_if<TraceOf<K>>(&trace);
  return found != nullptr && found->end < 0 ? std::optional(std::move(*found)) : std::nullopt;
}

#define EXSECT_INSTANTIATE(K)                                                                                \
  template std::optional<TraceOf<K>> trace_arc<K>(const PairOf<K>&, const std::vector<BoundaryPointOf<K>>&,  \
                                                  std::size_t, Vec4*);                                       \
  template std::optional<TraceOf<K>> trace_loop<K>(const PairOf<K>&, const std::vector<BoundaryPointOf<K>>&, \
                                                   const TubeOf<K>&, double);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
