#include "filter/turning.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "answer/parameter_box.h"
#include "filter/series.h"
#include "filter/tube_derivatives.h"

namespace exsect::filter {

namespace {

constexpr int kDeepestSplit = 30;
constexpr std::size_t kMostTurningPieces = 4000;
constexpr int kMostFromSource = 1000;

/// At the end of a piece: w_i' has this sign within kEndMargin<K::width> of it as well, where the
/// neighbouring piece, or the boundary point itself, begins.
template <class K>
int sign_near(const TubeOf<K>& tube, Direction<K> d, std::size_t i) {
  d.radius = kSlack * (d.radius + kEndMargin<K::width> * (std::fabs(tube.second[i]) + tube.second_error[i]));
  return d.middle[i] > d.radius ? 1 : d.middle[i] < -d.radius ? -1 : 0;
}

template <class K>
int sign_of(const Direction<K>& d, std::size_t i) {
  return d.middle[i] > d.radius ? 1 : d.middle[i] < -d.radius ? -1 : 0;
}

template <class K>
class TurnFinder {
 public:
  TurnFinder(const PairOf<K>& pair, TraceOf<K>& trace, const KnownTurning<K>& known,
             std::vector<TurnOf<K>>& turns, const DirectionSource<K>* source)
      : pair_(pair), trace_(trace), known_(known), turns_(turns), source_(source) {}

  TurnSearch run() {
    if (!decide_pieces()) {
      return TurnSearch::undecided;
    }
    for (std::size_t k = 0; k < trace_.pieces.size(); ++k) {
      const std::size_t begin = turns_.size();
      for (std::size_t i = 0; i < 4; ++i) {
        if (ends_[k].first[i] != ends_[k].last[i] && !bracket(k, i)) {
          return TurnSearch::undecided;
        }
      }
      const TurnSearch order = sort(begin);
      if (order != TurnSearch::done) {
        return order;
      }
    }
    return joined() ? TurnSearch::done : TurnSearch::undecided;
  }

 private:
  /// Signs of the change of each parameter along the trace at both ends of a piece; 0 for parameters that are
  /// left out. Where they differ, the parameter turns exactly once in between, and w'' is not 0; where not,
  /// never.
  struct Ends {
    std::array<int, 4> first;
    std::array<int, 4> last;
  };

  /// Pieces end and begin at offsets of one point in doubles, so with different points of the curve, less
  /// than kEndMargin<K::width> apart. What is between them lies on the arcs of both tubes, on which a
  /// parameter turns once at most, so not at all if it changes in the same sense on both sides.
  bool joined() const {
    for (std::size_t k = 0; k + 1 < ends_.size(); ++k) {
      if (ends_[k].last != ends_[k + 1].first) {
        return false;
      }
    }
    return trace_.start >= 0 || ends_.back().last == ends_.front().first;
  }

  Direction<K> direction(const TubeOf<K>& tube, double tau) const {
    const bool from_source = source_ != nullptr && left_ > 0;
    if (from_source) --left_;
    return from_source ? (*source_)(tube, tau) : direction_at(tube, tau);
  }

  bool is_left_out(std::size_t i) const {
    if (known_.coincident[i] < i || known_.constant[i]) {
      return true;
    }
    return known_.unasked[i] && known_.unasked[known_.coincident[i]];
  }

  static bool monotone(const TubeOf<K>& tube, std::size_t i) {
    return std::fabs(tube.slope[i]) > tube.slope_error[i];
  }
  static bool turns_once_at_most(const TubeOf<K>& tube, std::size_t i) {
    return std::fabs(tube.second[i]) > tube.second_error[i];
  }

  /// Fills in ends_, and divides pieces until this is possible.
  bool decide_pieces() {
    ends_.reserve(trace_.pieces.size());
    std::size_t k = 0;
    while (k < trace_.pieces.size() && decide(trace_.pieces[k], ends_.emplace_back()) == Decision::done) {
      ++k;
    }
    if (k == trace_.pieces.size()) {
      return true;
    }
    ends_.pop_back();
    std::vector<PieceOf<K>> done;
    done.reserve(2 * trace_.pieces.size() + 8);
    done.assign(trace_.pieces.begin(), trace_.pieces.begin() + static_cast<std::ptrdiff_t>(k));
    for (; k < trace_.pieces.size(); ++k) {
      if (!split(trace_.pieces[k], 0, done)) {
        return false;
      }
    }
    trace_.pieces = std::move(done);
    return true;
  }

  bool split(const PieceOf<K>& piece, int depth, std::vector<PieceOf<K>>& done) {
    Ends ends;
    switch (decide(piece, ends)) {
      case Decision::done:
        done.push_back(piece);
        ends_.push_back(ends);
        return true;
      case Decision::divide:
        return halve(piece, depth, done);
      case Decision::never:
        break;
    }
    return false;
  }

  bool halve(const PieceOf<K>& piece, int depth, std::vector<PieceOf<K>>& done) {
    if (depth >= kDeepestSplit || done.size() > kMostTurningPieces) {
      return false;
    }
    const double middle = piece.range.at(0.4853);
    PieceOf<K> half;
    return part(piece, piece.range.from(), middle, half) && split(half, depth + 1, done) &&
           part(piece, middle, piece.range.to(), half) && split(half, depth + 1, done);
  }

  enum class Decision { done, divide, never };

  Decision decide(const PieceOf<K>& piece, Ends& ends) const {
    ends = {};
    const int sense = piece.range.direction();
    std::optional<Direction<K>> first;
    std::optional<Direction<K>> last;
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_left_out(i)) {
        continue;
      }
      if (monotone(piece.tube, i)) {
        ends.first[i] = ends.last[i] = piece.tube.slope[i] > 0 ? sense : -sense;
        continue;
      }
      const int beside = rate_beside(known_.start_at, piece, i);
      const int rate = beside != 0 ? beside : rate_beside(known_.end_at, piece, i);
      if (rate != 0) {
        ends.first[i] = ends.last[i] = sense * rate;
        continue;
      }
      if (!first) {
        first = direction(piece.tube, piece.range.from());
        last = direction(piece.tube, piece.range.to());
      }
      ends.first[i] = sense * sign_near(piece.tube, *first, i);
      ends.last[i] = sense * sign_near(piece.tube, *last, i);
      if (turns_once_at_most(piece.tube, i)) {
        leave_out_end_points(piece, i, ends);
      }
      const bool known = ends.first[i] != 0 && ends.last[i] != 0;
      if (turns_once_at_most(piece.tube, i)) {
        if (!known) {
          return Decision::never;
        }
      } else if (!known || !keeps_sign(piece, *first, *last, i)) {
        return Decision::divide;
      }
    }
    return Decision::done;
  }

  /// The sign of dw_i by the piece's axis if the piece is on the arc of the side point, 0 if that is not
  /// known: with its ends it is, as between them it goes along the arc as long as the arc's axis is between
  /// its values there, which it is as it is monotone. Where it is in the domain the arc has the signs `rate`.
  static int rate_beside(const SidePointOf<K>* point, const PieceOf<K>& piece, std::size_t i) {
    if (point == nullptr || point->rate[i] == 0 || !monotone(piece.tube, point->tube.axis)) return 0;
    const auto is_on_arc = [&](double tau) { return contains(point->tube, point_at(piece.tube, tau)); };
    if (!is_on_arc(piece.range.from()) || !is_on_arc(piece.range.to())) return 0;
    return piece.tube.slope[point->tube.axis] > 0 ? point->rate[i] : -point->rate[i];
  }

  /// Where the only zero of w_i' on the tube's arc is an end point of the trace, there is none on the piece:
  /// the sign at the other end is that all along.
  void leave_out_end_points(const PieceOf<K>& piece, std::size_t i, Ends& ends) const {
    if (known_.at_start[i] && contains(piece.tube, *known_.start)) {
      ends.first[i] = ends.last[i];
    } else if (known_.at_end[i] && contains(piece.tube, *known_.end)) {
      ends.last[i] = ends.first[i];
    }
  }

  /// (14.16): w_i' with one sign at both ends has no zero if by its least and greatest derivative it cannot
  /// reach zero from one end before the place from which it could have come to the other. Requires that zero
  /// is between these derivatives.
  static bool keeps_sign(const PieceOf<K>& piece, const Direction<K>& first, const Direction<K>& last,
                         std::size_t i) {
    if (sign_of(first, i) != sign_of(last, i)) {
      return false;
    }
    const bool forward = piece.range.direction() > 0;
    const Direction<K>& left = forward ? first : last;
    const Direction<K>& right = forward ? last : first;
    const double second = sign_of(first, i) * piece.tube.second[i];
    const double descent = piece.tube.second_error[i] - second;
    const double ascent = piece.tube.second_error[i] + second;
    return kSlack * piece.range.length() * descent * ascent <
           (std::fabs(left.middle[i]) - left.radius) * ascent +
               (std::fabs(right.middle[i]) - right.radius) * descent;
  }

  /// A part of the piece on a tube of its own, with the same axis: both arcs start in the same point and go
  /// the same way.
  bool part(const PieceOf<K>& piece, double from, double to, PieceOf<K>& result) const {
    const TubeOf<K>& tube = piece.tube;
    const BallOf<K> start = point_at(tube, from);
    const BallOf<K> end = point_at(tube, to);
    const BallOf<K> centre = point_at(tube, 0.5 * (from + to));
    const double radius = larger_bound(start.radius, end.radius, centre.radius);
    if (!prepare(pair_, centre.middle, tube.axis, result.tube)) {
      return false;
    }
    const double reach = 0.505 * std::fabs(to - from) + 4 * radius;
    const Row<K> residual = residual_bound(pair_, result.tube, reach);
    if (radius > 0x1p-2 * kEndMargin<K::width> ||
        !certify(pair_, result.tube, -reach, reach, halfwidths<K>(residual, kLeastHalfwidth<K::width>),
                 residual) ||
        !contains(result.tube, start) || !contains(result.tube, end)) {
      return false;
    }
    bound_derivatives(pair_, result.tube);
    expand_arc(result.tube);
    const double centre_at = result.tube.centre[tube.axis];
    const auto range = PieceRange::between(start.middle[tube.axis] - centre_at,
                                           end.middle[tube.axis] - centre_at, 2 * radius);
    if (!range || range->direction() != piece.range.direction()) {
      return false;
    }
    result.range = *range;
    return true;
  }

  /// A guess of the zero of w_i' by the secant method on the arc's polynomial and Newton's method on the arc;
  /// then an interval around it that must hold the zero because |w_i''| has a lower bound, or, if that is too
  /// wide, one with certain signs on both sides.
  bool bracket(std::size_t k, std::size_t i) {
    const PieceOf<K>& piece = trace_.pieces[k];
    const TubeOf<K>& tube = piece.tube;
    double t = zero_of_polynomial(piece, i);
    Direction<K> d = direction(tube, t);
    for (int step = 0; step < 8 && std::fabs(d.middle[i]) > 0.02 * d.radius; ++step) {
      t = piece.range.clamped(t - d.middle[i] / arc_second(tube, t, i));
      d = direction(tube, t);
    }
    const double farthest = kSlack * (std::fabs(d.middle[i]) + d.radius);
    const double bound = 1.05 * farthest / (std::fabs(tube.second[i]) - tube.second_error[i]) + kPlacing;
    if (bound < 4 * d.radius / std::fabs(tube.second[i])) {
      const auto [from, to] = around(piece, t, bound);
      return record(k, i, from, to);
    }
    for (double delta = 2.5 * d.radius / std::fabs(tube.second[i]) + kPlacing; delta < kLargestBox<K::width>;
         delta *= 2) {
      const auto [from, to] = around(piece, t, delta);
      const int before = sign_of(direction(tube, from), i);
      if (before != 0 && before == -sign_of(direction(tube, to), i)) {
        return record(k, i, from, to);
      }
    }
    return false;
  }

  /// The offsets t -+ delta, as far as they are on the piece, in the direction of the trace.
  static std::pair<double, double> around(const PieceOf<K>& piece, double t, double delta) {
    return {piece.range.ahead_of(t, -delta), piece.range.ahead_of(t, delta)};
  }

  static double zero_of_polynomial(const PieceOf<K>& piece, std::size_t i) {
    double a = piece.range.from();
    double b = piece.range.to();
    double fa = arc_slope(piece.tube, a)[i];
    double fb = arc_slope(piece.tube, b)[i];
    double t = b;
    for (int step = 0; step < 40; ++step) {
      t = (a * fb - b * fa) / (fb - fa);
      const double ft = arc_slope(piece.tube, t)[i];
      if (!(std::fabs(ft) > 0x1p-45)) {
        break;
      }
      if (std::signbit(ft) == std::signbit(fb)) {
        fa *= 0.5;  // Illinois
      } else {
        a = b;
        fa = fb;
      }
      b = t;
      fb = ft;
    }
    const bool usable = t >= piece.range.least() && t <= piece.range.greatest();
    return usable ? t : piece.range.at(0.5);
  }

  bool record(std::size_t k, std::size_t i, double from, double to) {
    const TubeOf<K>& tube = trace_.pieces[k].tube;
    double steep = 1;
    for (std::size_t j = 0; j < 4; ++j) {
      steep = larger_bound(steep, std::fabs(tube.slope[j]) + tube.slope_error[j]);
    }
    TurnOf<K> turn = {i, k, from, to, point_at(tube, 0.5 * (from + to))};
    turn.ball.radius = kSlack * (turn.ball.radius + steep * (0.5 * std::fabs(to - from) + kSumRounding));
    turns_.push_back(turn);
    // All of the node's box in the region: no other turning point with respect to i is there.
    return turn.ball.radius < kLargestBox<K::width> &&
           contains(tube, {turn.ball.middle, turn.ball.radius + kPlacing});
  }

  /// In the order of the trace; the brackets of one piece must be disjoint.
  TurnSearch sort(std::size_t begin) {
    const auto first = turns_.begin() + static_cast<std::ptrdiff_t>(begin);
    if (turns_.end() - first < 2) {
      return TurnSearch::done;
    }
    const PieceRange& range = trace_.pieces[first->piece].range;
    std::sort(first, turns_.end(),
              [&](const TurnOf<K>& a, const TurnOf<K>& b) { return range.precedes(a.from, b.from); });
    for (auto turn = first; turn + 1 != turns_.end(); ++turn) {
      const TurnOf<K>& next = *(turn + 1);
      if (!range.precedes(turn->to, next.from)) {
        return turn->parameter / 2 != next.parameter / 2 ? TurnSearch::not_separated : TurnSearch::undecided;
      }
    }
    return TurnSearch::done;
  }

  const PairOf<K>& pair_;
  TraceOf<K>& trace_;
  const KnownTurning<K>& known_;
  std::vector<TurnOf<K>>& turns_;
  const DirectionSource<K>* source_;
  mutable int left_ = kMostFromSource;
  std::vector<Ends> ends_;  // of trace_.pieces
};

}  // namespace

template <class K>
TurnSearch find_turns(const PairOf<K>& pair, TraceOf<K>& trace, const KnownTurning<K>& known,
                      std::vector<TurnOf<K>>& turns, const DirectionSource<K>* source) {
  return TurnFinder<K>(pair, trace, known, turns, source).run();
}

#define EXSECT_INSTANTIATE(K)                                                              \
  template TurnSearch find_turns<K>(const PairOf<K>&, TraceOf<K>&, const KnownTurning<K>&, \
                                    std::vector<TurnOf<K>>&, const DirectionSource<K>*);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
