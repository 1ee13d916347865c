// The tracer: follows a curve by overlapping tubes, whatever the equations that the tubes are proved with.
// Internal to solver/; docs/method.md, section 5.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/algebra/double_double_ball.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "answer/stop_request.h"
#include "trace/steps.h"
#include "trace/tube_trace.h"

namespace exsect {

/// The least step in a kind of numbers.
template <class Ball>
struct LeastStep;
template <>
struct LeastStep<DoubleBall> {
  static constexpr double of(const Steps& steps) { return steps.least; }
};
template <>
struct LeastStep<DoubleDoubleBall> {
  static constexpr double of(const Steps& steps) { return steps.least_of_two; }
};
template <long Bits>
struct LeastStep<ArbBall<Bits>> {
  static constexpr double of(const Steps&) { return Bits > 256 ? 0x1p-450 : 0x1p-110; }
};

template <class Ball>
TraceFailure trace_failure(const BallPoint<Ball>& at, const char* why) {
  return {{at[0].approximation(), at[1].approximation(), at[2].approximation(), at[3].approximation()}, why};
}

/// No point of the box is known to be outside the domain [0,1]^4.
template <class Ball>
bool may_be_in_domain(const BallPoint<Ball>& box) {
  return std::none_of(box.begin(), box.end(),
                      [](const Ball& c) { return c.is_negative() || (c - Ball(1)).is_positive(); });
}

/// A curve point in a small box, and how to go on from there. `Course` proposes the tubes, one kind of
/// curves each; this class decides what they meet, and so what is proved. A Course has
///   Number, Tube              types, with offset(tube, box), contains(tube, box), excludes(tube, box)
///   steps, too_small          its row of the table, and what is said where steps become too small
///   starts_inside             closed curves start inside their first tube, not at the seed
///   set_out(trace, position)  before a step: nullptr, or why there is none
///   may_try(), shorter(had)   another attempt at this step; after one that failed, with or without a tube
///   next_tube()               a tube that contains the position, or none
///   direction()               the sign of that tube's offsets ahead
///   joint(tube)               where the next tube starts: offset, and box around the point there
///   taken(tube)               after a step
template <class Course>
class TubeTracer {
 public:
  using Ball = typename Course::Number;
  using Tube = typename Course::Tube;

  TubeTracer(Course course, const Landmarks<Ball>& landmarks, const StopRequest& stop)
      : course_(std::move(course)), landmarks_(landmarks), stop_(stop) {}

  /// From the curve point in the box to the first landmark met, or until the curve closes. start_landmark:
  /// index of the box, -1 if it is no landmark.
  std::variant<TubeTrace<Tube>, TraceFailure> run(const BallPoint<Ball>& start, int start_landmark) {
    position_ = start;
    trace_.start = start_landmark;
    trace_.ends[0] = start;
    if (start_landmark < 0 && !Course::starts_inside) {
      closing_ = start;
    }
    while (trace_.pieces.size() < Course::steps.most_pieces) {
      if (stop_ && stop_()) {
        return trace_failure(position_, "the work cap was reached");
      }
      if (const char* why = advance()) {
        return trace_failure(position_, why);
      }
      if (finished_) {
        return std::move(trace_);
      }
    }
    return trace_failure(position_, "too many steps along one curve");
  }

 private:
  struct Met {
    int landmark = -1;
    Ball at;
  };

  /// One tube from the current position; sets finished_ at a landmark or where a closed curve closes. Why it
  /// cannot, or nullptr.
  const char* advance() {
    if (const char* why = course_.set_out(trace_, position_)) {
      return why;
    }
    while (course_.may_try()) {
      const std::optional<Tube> tube = course_.next_tube();
      if (tube && accept(*tube)) {
        course_.taken(*tube);
        return nullptr;
      }
      course_.shorter(tube.has_value());
    }
    return Course::too_small;
  }

  /// Decides every landmark on the tube; ends at the first one ahead, else moves on to the far end.
  bool accept(const Tube& tube) {
    const Ball here = offset(tube, position_);
    const std::optional<Met> met = first_ahead(tube, here);
    if (!met) {
      return false;
    }
    const bool closes = closing_ && contains(tube, *closing_) &&
                        course_.direction() * (offset(tube, *closing_) - here).certain_sign() > 0;
    if (closes && met->landmark >= 0) {
      return false;
    }
    if (met->landmark < 0 && !closes) {
      return move_to_end(tube, here);
    }
    if (!add_piece(tube, here, closes ? offset(tube, *closing_) : met->at)) {
      return false;
    }
    trace_.end = met->landmark;
    if (met->landmark >= 0) {
      trace_.ends[1] = landmarks_[static_cast<std::size_t>(met->landmark)];
    }
    finished_ = true;
    return true;
  }

  /// The first landmark ahead on the tube, if there is one; empty if the tube does not decide that.
  std::optional<Met> first_ahead(const Tube& tube, const Ball& here) const {
    const int direction = course_.direction();
    Met met;
    for (int i = 0; i < static_cast<int>(landmarks_.size()); ++i) {
      const BallPoint<Ball>& box = landmarks_[static_cast<std::size_t>(i)];
      if ((trace_.pieces.empty() && i == trace_.start) || excludes(tube, box)) {
        continue;
      }
      const Ball at = offset(tube, box);
      const int ahead = direction * (at - here).certain_sign();
      if (ahead < 0) {
        continue;
      }
      if (ahead == 0 || !contains(tube, box)) {
        return std::nullopt;
      }
      const int order = met.landmark < 0 ? -1 : direction * (at - met.at).certain_sign();
      if (order == 0) {
        return std::nullopt;
      }
      if (order < 0) {
        met = {i, at};
      }
    }
    return met;
  }

  /// Of the tube, between two offsets; false if the second one is not certainly ahead of the first one.
  bool add_piece(const Tube& tube, const Ball& from, const Ball& to) {
    const auto range = PieceRange::between(from, to);
    if (!range || range->direction() != course_.direction()) {
      return false;
    }
    trace_.pieces.push_back({tube, *range});
    return true;
  }

  bool move_to_end(const Tube& tube, const Ball& here) {
    const auto [to, end] = course_.joint(tube);
    if (!may_be_in_domain(end)) {
      return false;  // left the domain without meeting a boundary point: take smaller steps
    }
    const bool starts_loop = Course::starts_inside && trace_.start < 0 && trace_.pieces.empty();
    const Ball from = starts_loop ? Ball(inside_first_piece(here, to)) : here;
    if (!add_piece(tube, from, Ball(to))) {
      return false;
    }
    if constexpr (Course::starts_inside) {
      if (starts_loop) {
        closing_ = point_at(tube, trace_.pieces.front().range.from());
      }
    }
    position_ = end;
    return true;
  }

  /// A closed curve starts at an odd place of its first tube, so that the seed's special position (a sample u
  /// where symmetric curves turn) is never a joint.
  static double inside_first_piece(const Ball& here, double to) {
    return here.approximation() + 0.61803 * (to - here.approximation());
  }

  Course course_;
  const Landmarks<Ball>& landmarks_;
  const StopRequest& stop_;
  TubeTrace<Tube> trace_;
  BallPoint<Ball> position_;
  std::optional<BallPoint<Ball>> closing_;
  bool finished_ = false;
};

}  // namespace exsect
