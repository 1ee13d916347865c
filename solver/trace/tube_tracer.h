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

/// Pieces for which a trace has room at once.
inline constexpr std::size_t kUsualPieces = 16;

/// The box around a landmark.
template <class Ball>
const BallPoint<Ball>& landmark_box(const BallPoint<Ball>& landmark) {
  return landmark;
}

/// A curve point in a small box, and how to go on from there. `Course` proposes the tubes, one kind of
/// curves each; this class decides what they meet, and so what is proved. A Course has
///   Box, Offset, Trace, Tube  types: a place with its error, a place along a tube, and the result, which is
///                             a TubeTrace, with offset(tube, box), contains(tube, box), excludes(tube, box),
///                             point_at(tube, tau), may_be_in_domain(box), trace_failure(box, why)
///   Landmarks                 a container of what has landmark_box(landmark)
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
  using Box = typename Course::Box;
  using Offset = typename Course::Offset;
  using Trace = typename Course::Trace;
  using Tube = typename Course::Tube;

  TubeTracer(Course course, const typename Course::Landmarks& landmarks, const StopRequest& stop)
      : course_(std::move(course)), landmarks_(landmarks), stop_(stop) {}

  /// From the curve point in the box to the first landmark met, or until the curve closes. start_landmark:
  /// index of the box, -1 if it is no landmark.
  std::variant<Trace, TraceFailure> run(const Box& start, int start_landmark) {
    position_ = start;
    trace_.start = start_landmark;
    trace_.ends[0] = start;
    trace_.pieces.reserve(kUsualPieces);
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
  /// What is first ahead on a tube: a landmark, the closed curve's first point, or nothing.
  struct Met {
    int landmark = -1;
    bool closes = false;
    Offset at = Offset(0);

    bool is_something() const { return closes || landmark >= 0; }
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
    const Offset here = offset(tube, position_);
    const std::optional<Met> met = first_ahead(tube, here);
    if (!met) {
      return false;
    }
    if (!met->is_something()) {
      return move_to_end(tube, here);
    }
    if (!add_piece(tube, here, met->at)) {
      return false;
    }
    trace_.end = met->landmark;
    if (met->landmark >= 0) {
      trace_.ends[1] = landmark_box(landmarks_[static_cast<std::size_t>(met->landmark)]);
    }
    finished_ = true;
    return true;
  }

  /// The first thing ahead on the tube, if there is one; empty if the tube does not decide that.
  std::optional<Met> first_ahead(const Tube& tube, const Offset& here) const {
    Met met;
    for (int i = 0; i < static_cast<int>(landmarks_.size()); ++i) {
      if (trace_.pieces.empty() && i == trace_.start) {
        continue;
      }
      const Box& box = landmark_box(landmarks_[static_cast<std::size_t>(i)]);
      if (!consider(tube, here, box, {i, false}, met)) {
        return std::nullopt;
      }
    }
    if (closing_ && !trace_.pieces.empty() && !consider(tube, here, *closing_, {-1, true}, met)) {
      return std::nullopt;
    }
    return met;
  }

  /// Sets `met` to `next`, what is at the box, if that is ahead and before it. False if the tube does not
  /// decide whether it is.
  bool consider(const Tube& tube, const Offset& here, const Box& box, Met next, Met& met) const {
    if (excludes(tube, box)) {
      return true;
    }
    const int direction = course_.direction();
    next.at = offset(tube, box);
    const int ahead = direction * (next.at - here).certain_sign();
    if (ahead < 0) {
      return true;
    }
    if (ahead == 0 || !contains(tube, box)) {
      return false;
    }
    const int order = met.is_something() ? direction * (next.at - met.at).certain_sign() : -1;
    if (order < 0) {
      met = next;
    }
    return order != 0;
  }

  /// Of the tube, between two offsets; false if the second one is not certainly ahead of the first one.
  bool add_piece(const Tube& tube, const Offset& from, const Offset& to) {
    const auto range = PieceRange::between(from, to);
    if (!range || range->direction() != course_.direction()) {
      return false;
    }
    trace_.pieces.push_back({tube, *range});
    return true;
  }

  bool move_to_end(const Tube& tube, const Offset& here) {
    const auto [to, end] = course_.joint(tube);
    if (!may_be_in_domain(end)) {
      return false;  // left the domain without meeting a boundary point: take smaller steps
    }
    const bool starts_loop = Course::starts_inside && trace_.start < 0 && trace_.pieces.empty();
    const Offset from = starts_loop ? Offset(inside_first_piece(here, to)) : here;
    if (!add_piece(tube, from, Offset(to))) {
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
  static double inside_first_piece(const Offset& here, double to) {
    return here.approximation() + 0.61803 * (to - here.approximation());
  }

  Course course_;
  const typename Course::Landmarks& landmarks_;
  const StopRequest& stop_;
  Trace trace_;
  Box position_;
  std::optional<Box> closing_;
  bool finished_ = false;
};

}  // namespace exsect
