// The search of a trace's turning points, whatever the equations that its tubes are proved with. Internal to
// solver/; docs/method.md, section 5.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "answer/stop_request.h"
#include "trace/split_pieces.h"
#include "trace/tube_tracer.h"
#include "trace/turning_points.h"

namespace exsect {

/// A ball around both.
template <class Ball>
Ball ball_hull(const Ball& a, const Ball& b) {
  return a.widened((a.midpoint() - b.midpoint()).upper_magnitude() + b.radius());
}

/// The offset to which the trace comes later.
inline double later(const PieceRange& range, double a, double b) { return range.precedes(a, b) ? b : a; }

/// Splits the pieces of a trace until each parameter turns at most once on each, and encloses where. The
/// Course knows the equations; it has
///   Number, Piece             types; a Piece has a tube and a range
///   most_pieces               beyond which splitting is given up
///   is_simple(piece)          each parameter is monotone or constant, or turns at most once on the piece
///   part(piece, from, to)     the part between two offsets on a tube of its own, or none
///   may_turn(piece, j)        parameter j is not known to be monotone or constant on the piece
///   sign_at(piece, tau, j)    of the derivative of parameter j, 0: not known, up to one factor on a piece
///   slope_at(piece, tau, j)   about that derivative, up to one positive or negative factor on a piece
///   end_sign(k, j, at_end)    sign_at where piece k begins or ends, from all that is known; 0: it vanishes
///   knows_end(k, j, at_end)   that sign is known, and a shorter tube may show it
///   unit(piece)               width of the smallest brackets
///   are_one(a, b)             turning points whose brackets meet are one point of the curve
///   magnify(k, at)            cuts piece k so that a shorter tube is about the offset; false if it cannot
///   pair(piece, box)          the parameters (u,v,r,s) of a box on the piece
template <class Course>
class TurningSearch {
 public:
  using Ball = typename Course::Number;
  using Piece = typename Course::Piece;

  /// `coincident` as in find_turning_points().
  TurningSearch(Course course, std::vector<Piece>& pieces, const std::array<std::size_t, 4>& coincident,
                const StopRequest& stop)
      : course_(std::move(course)), pieces_(pieces), coincident_(coincident), stop_(stop) {}

  /// All turning points in the order of the trace; a failure where one cannot be separated from another one
  /// or from an end, and where the search must stop.
  std::variant<TurningPoints<Ball>, TraceFailure> run() {
    if (!split()) {
      return failure_;
    }
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (is_stopped(stop_)) {
        fail(pieces_[k], pieces_[k].range.from(), "the work cap was reached");
        return failure_;
      }
      const std::size_t before = found_.size();
      std::optional<double> close = search(k);
      if (!close) {
        close = order(before);
      }
      if (!close) {
        continue;
      }
      if (hopeless_ || !course_.magnify(k, *close)) {
        return failure_;
      }
      found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(before), found_.end());
      --k;
    }
    return std::move(found_);
  }

 private:
  bool split() {
    const auto is_simple = [this](const Piece& piece) { return course_.is_simple(piece); };
    const auto part = [this](const Piece& piece, double from, double to) {
      return course_.part(piece, from, to);
    };
    const auto failure = split_pieces(pieces_, Course::most_pieces, is_simple, part);
    if (failure) fail(failure->piece, failure->at, failure->why);
    return !failure;
  }

  /// Finds the turning points on piece k. Otherwise an offset about which a shorter tube may tell more.
  std::optional<double> search(std::size_t k) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (course_.may_turn(pieces_[k], j) && (j < 2 || coincident_[j] == j)) {
        if (const auto close = search(k, j)) {
          return close;
        }
      }
    }
    return std::nullopt;
  }

  /// With respect to parameter j.
  std::optional<double> search(std::size_t k, std::size_t j) {
    const Piece& piece = pieces_[k];
    const std::optional<int> first = course_.end_sign(k, j, false);
    const std::optional<int> last = course_.end_sign(k, j, true);
    if (!first || !last) {
      hopeless_ = !course_.knows_end(k, j, first.has_value());
      const double at = !first ? piece.range.from() : piece.range.to();
      fail(piece, at, "a turning point cannot be separated from the end of a step or a boundary point");
      return at;
    }
    // If it is 0 at an end, the parameter turns at most once on the piece: there, at the end of the trace.
    if (*first * *last >= 0 || bracket(k, j, *first)) {
      return std::nullopt;
    }
    hopeless_ = true;
    fail(piece, piece.range.at(0.5), "a turning point could not be enclosed");
    return piece.range.at(0.5);
  }

  /// Regula falsi (Illinois) for an estimate of the zero of the slope.
  double estimated_zero(const Piece& piece, std::size_t j) const {
    double a = piece.range.from();
    double b = piece.range.to();
    double fa = course_.slope_at(piece, a, j);
    double fb = course_.slope_at(piece, b, j);
    double t = 0.5 * (a + b);
    const double unit = course_.unit(piece);
    for (int step = 0; step < 60 && std::fabs(b - a) > unit; ++step) {
      const double next = (a * fb - b * fa) / (fb - fa);
      const bool settled = std::fabs(next - t) < unit;
      t = next;
      const double ft = course_.slope_at(piece, t, j);
      if (ft == 0 || settled) {
        break;
      }
      if (std::signbit(ft) == std::signbit(fb)) {
        fa *= 0.5;
      } else {
        a = b;
        fa = fb;
      }
      b = t;
      fb = ft;
    }
    return t;
  }

  /// Certain signs on both sides of the estimate.
  bool bracket(std::size_t k, std::size_t j, int first_sign) {
    const Piece& piece = pieces_[k];
    const double t = estimated_zero(piece, j);
    for (double delta = 2 * course_.unit(piece); delta < 1; delta *= 4) {
      const double from = piece.range.ahead_of(t, -delta);
      const double to = piece.range.ahead_of(t, delta);
      const int s0 = course_.sign_at(piece, from, j);
      const int s1 = course_.sign_at(piece, to, j);
      if (s0 == first_sign && s1 == -first_sign) {
        std::vector<std::size_t> parameters = {j};
        if (coincident_[j] != j) {
          parameters.push_back(coincident_[j]);
        }
        found_.push_back({parameters, k, from, to, box_between(piece.tube, from, to)});
        return true;
      }
    }
    return false;
  }

  /// Sorts the turning points of one piece. Their brackets must be disjoint; else an offset where they are
  /// not.
  std::optional<double> order(std::size_t begin) {
    const auto first = found_.begin() + static_cast<std::ptrdiff_t>(begin);
    if (found_.end() - first < 2) {
      return std::nullopt;
    }
    const PieceRange range = pieces_[first->piece].range;
    std::sort(first, found_.end(), [&](const TurningPoint<Ball>& a, const TurningPoint<Ball>& b) {
      return range.precedes(a.from, b.from);
    });
    for (auto point = first; point + 1 != found_.end(); ++point) {
      TurningPoint<Ball>& next = *(point + 1);
      if (range.precedes(point->to, next.from)) {
        continue;
      }
      if (!course_.are_one(*point, next)) {
        const double at = 0.5 * (point->from + next.to);
        fail(pieces_[point->piece], at, "turning points with respect to two parameters cannot be separated");
        return at;
      }
      next.parameters.insert(next.parameters.begin(), point->parameters.begin(), point->parameters.end());
      for (std::size_t i = 0; i < 4; ++i) {
        next.box[i] = ball_hull(point->box[i], next.box[i]);
      }
      next.from = point->from;
      next.to = later(range, point->to, next.to);
      point->parameters.clear();
    }
    found_.erase(std::remove_if(first, found_.end(),
                                [](const TurningPoint<Ball>& point) { return point.parameters.empty(); }),
                 found_.end());
    return std::nullopt;
  }

  void fail(const Piece& piece, double at, const char* why) {
    failure_ = trace_failure(course_.pair(piece, point_at(piece.tube, at)), why);
  }

  Course course_;
  std::vector<Piece>& pieces_;
  const std::array<std::size_t, 4>& coincident_;
  const StopRequest& stop_;
  TurningPoints<Ball> found_;
  TraceFailure failure_;
  bool hopeless_ = false;  // no shorter tube would help
};

}  // namespace exsect
