#include "trace/turning_points.h"

#include <algorithm>
#include <cmath>

#include "answer/parameter_box.h"
#include "trace/shorter_piece.h"
#include "trace/split_pieces.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

/// Pieces of one trace beyond which splitting is given up: a parameter that is nearly constant.
template <class Ball>
constexpr std::size_t kMostTurningPieces = 100000;
template <>
inline constexpr std::size_t kMostTurningPieces<DoubleDoubleBall> = 20000;
template <long Bits>
inline constexpr std::size_t kMostTurningPieces<ArbBall<Bits>> = 3000;

/// Width of the smallest brackets; 0: as narrow as doubles tell offsets apart on the tube.
template <class Ball>
constexpr double kUnit = 0x1p-50;
template <>
inline constexpr double kUnit<DoubleDoubleBall> = 0;
template <long Bits>
inline constexpr double kUnit<ArbBall<Bits>> = 0;

/// The part of a piece that is given a tube of its own where turning points are close together, and its least
/// length.
constexpr double kMagnified = 0x1p-30;
template <class Ball>
constexpr double kLeastMagnified = 0x1p-110;
template <long Bits>
inline constexpr double kLeastMagnified<ArbBall<Bits>> = Bits > 256 ? 0x1p-500 : 0x1p-160;
constexpr int kMostMagnified = 64;  // times, of one trace

/// By this part of the tube's reach the ends of pieces are padded.
constexpr double kPad = 1.0 / 1024;

template <class Ball>
std::array<int, 4> signs_of_tangent(const PairSystem<Ball>& system, const BallPoint<Ball>& at) {
  const BallPoint<Ball> t = Expansion<Ball>(system, at).tangent();
  return {t[0].certain_sign(), t[1].certain_sign(), t[2].certain_sign(), t[3].certain_sign()};
}

/// The range of offsets that a piece needs: at its ends the points are known up to a small part of the tube.
template <class Ball>
std::array<double, 2> padded(const Piece<Ball>& piece) {
  const double reach = piece.tube.reach;
  const double pad = piece.range.direction() * kPad * reach;
  return {std::clamp(piece.range.from() - pad, -reach, reach),
          std::clamp(piece.range.to() + pad, -reach, reach)};
}

template <class Ball>
bool is_monotone(const Piece<Ball>& piece, std::size_t i) {
  const auto [from, to] = padded(piece);
  return slope_between(piece.tube, i, from, to).has_sign();
}

template <class Ball>
bool turns_at_most_once(const Piece<Ball>& piece, std::size_t i) {
  const auto [from, to] = padded(piece);
  return second_between(piece.tube, i, from, to).has_sign();
}

template <class Ball>
class TurningSearch {
 public:
  TurningSearch(const PairSystem<Ball>& system, Trace<Ball>& trace,
                const std::array<std::size_t, 4>& coincident, const KnownTangent& known)
      : system_(system), trace_(trace), coincident_(coincident), known_(known) {}

  std::variant<TurningPoints<Ball>, TraceFailure> run() {
    if (kUnit<Ball> == 0) {
      resolve_short_arc(system_, trace_);
    }
    if (!split()) {
      return failure_;
    }
    for (std::size_t k = 0; k < trace_.pieces.size(); ++k) {
      const std::size_t before = found_.size();
      std::optional<double> close = search(k);
      if (!close) {
        close = order(before);
      }
      if (!close) {
        continue;
      }
      if (hopeless_ || !magnify(k, *close)) {
        return failure_;
      }
      found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(before), found_.end());
      --k;
    }
    return std::move(found_);
  }

 private:
  /// Splits every piece until each parameter is monotone or turns at most once on it.
  bool split() {
    const auto is_simple = [this](const Piece<Ball>& piece) {
      return std::all_of(all_parameters.begin(), all_parameters.end(), [&](Parameter p) {
        const std::size_t i = index(p);
        return known_.constant[i] || is_monotone(piece, i) || turns_at_most_once(piece, i);
      });
    };
    const auto part_of = [this](const Piece<Ball>& piece, double from, double to) {
      return shorter_piece(system_, piece, from, to);
    };
    const auto failure = split_pieces(trace_.pieces, kMostTurningPieces<Ball>, is_simple, part_of);
    if (failure) fail(point_at(failure->piece.tube, failure->at), failure->why);
    return !failure;
  }

  /// Finds the turning points on piece k. Otherwise an offset about which a shorter tube may tell more.
  std::optional<double> search(std::size_t k) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (!known_.constant[i] && (i < 2 || coincident_[i] == i)) {
        if (const auto close = search(k, i)) {
          return close;
        }
      }
    }
    return std::nullopt;
  }

  /// With respect to parameter i.
  std::optional<double> search(std::size_t k, std::size_t i) {
    const Piece<Ball>& piece = trace_.pieces[k];
    if (is_monotone(piece, i)) {
      return std::nullopt;
    }
    const std::optional<int> first = sign_at(k, i, false);
    const std::optional<int> last = sign_at(k, i, true);
    if (!first || !last) {
      const bool at_end = first.has_value();
      hopeless_ = is_joint(k, at_end) || !(at_end ? known_.at_end : known_.at_start)[i];
      const double at = !first ? piece.range.from() : piece.range.to();
      fail(point_at(piece.tube, at),
           "a turning point cannot be separated from the end of a step or a boundary point");
      return at;
    }
    // If it is 0 at an end, the parameter turns at most once on the piece: there, at the end of the trace.
    if (*first * *last >= 0 || bracket(k, i, *first)) {
      return std::nullopt;
    }
    hopeless_ = true;
    fail(point_at(piece.tube, piece.range.at(0.5)), "a turning point could not be enclosed");
    return piece.range.at(0.5);
  }

  /// Where piece k begins, or ends, another one ends or begins.
  bool is_joint(std::size_t k, bool at_end) const {
    return trace_.start < 0 || (at_end ? k + 1 < trace_.pieces.size() : k > 0);
  }

  /// The sign of T_i where piece k begins or ends. At an end of an open trace 0 if T_i is known to vanish
  /// there; otherwise the sign at the offset that stands for the end point must be the one at that point, so
  /// that the parameter does not turn in between, perhaps outside the domain.
  std::optional<int> sign_at(std::size_t k, std::size_t i, bool at_end) const {
    const Piece<Ball>& piece = trace_.pieces[k];
    const int sign =
        signs_of_tangent(system_, point_at(piece.tube, at_end ? piece.range.to() : piece.range.from()))[i];
    if (is_joint(k, at_end)) {
      return sign == 0 ? std::nullopt : std::optional(sign);
    }
    const std::optional<int> known = (at_end ? known_.at_end : known_.at_start)[i];
    return known == 0 || known == sign ? known : std::nullopt;
  }

  double slope_at(const Tube<Ball>& tube, double tau, std::size_t i) const {
    const BallPoint<Ball> t = Expansion<Ball>(system_, point_at(tube, tau)).tangent();
    return t[i].approximation() / t[tube.axis].approximation();
  }

  /// Regula falsi (Illinois) for an estimate of the zero of T_i/T_k, then certain signs on both sides of it.
  bool bracket(std::size_t k, std::size_t i, int first_sign) {
    const Piece<Ball>& piece = trace_.pieces[k];
    double a = piece.range.from();
    double b = piece.range.to();
    double fa = slope_at(piece.tube, a, i);
    double fb = slope_at(piece.tube, b, i);
    double t = 0.5 * (a + b);
    const double unit = kUnit<Ball> > 0 ? kUnit<Ball> : 0x1p-50 * piece.tube.reach;
    for (int step = 0; step < 60 && std::fabs(b - a) > unit; ++step) {
      const double next = (a * fb - b * fa) / (fb - fa);
      const bool settled = std::fabs(next - t) < unit;
      t = next;
      const double ft = slope_at(piece.tube, t, i);
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
    for (double delta = 2 * unit; delta < 1; delta *= 4) {
      const double from = piece.range.ahead_of(t, -delta);
      const double to = piece.range.ahead_of(t, delta);
      const int s0 = signs_of_tangent(system_, point_at(piece.tube, from))[i];
      const int s1 = signs_of_tangent(system_, point_at(piece.tube, to))[i];
      if (s0 == first_sign && s1 == -first_sign) {
        record(k, i, from, to);
        return true;
      }
    }
    return false;
  }

  void record(std::size_t k, std::size_t i, double from, double to) {
    std::vector<std::size_t> parameters = {i};
    if (coincident_[i] != i) {
      parameters.push_back(coincident_[i]);
    }
    found_.push_back({parameters, k, from, to, box_between(trace_.pieces[k].tube, from, to)});
  }

  /// Gives the surroundings of an offset on piece k a tube of their own, so short that doubles tell offsets
  /// apart that they could not on the piece; false if balls are no finer than doubles, or after many times.
  bool magnify(std::size_t k, double at) {
    const Piece<Ball> piece = trace_.pieces[k];
    const double half = kMagnified * piece.range.length();
    if (kUnit < Ball >> 0 || !(half > kLeastMagnified<Ball>) || ++magnified_ > kMostMagnified) {
      return false;
    }
    const double last = piece.range.to();
    const std::array<double, 4> cuts = {piece.range.from(), piece.range.ahead_of(at, -half),
                                        piece.range.ahead_of(at, half), last};
    std::vector<Piece<Ball>> parts;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!piece.range.precedes(cuts[i], cuts[i + 1])) {
        continue;  // close to an end of the piece
      }
      const bool starts = parts.empty() && !is_joint(k, false);
      const bool ends = !piece.range.precedes(cuts[i + 1], last) && !is_joint(k, true);
      const auto result =
          shorter_piece(system_, piece, starts ? trace_.ends[0] : point_at(piece.tube, cuts[i]),
                        ends ? trace_.ends[1] : point_at(piece.tube, cuts[i + 1]),
                        point_at(piece.tube, 0.5 * (cuts[i] + cuts[i + 1])));
      if (!result) {
        return false;
      }
      parts.push_back(*result);
    }
    const auto place = trace_.pieces.erase(trace_.pieces.begin() + static_cast<std::ptrdiff_t>(k));
    trace_.pieces.insert(place, parts.begin(), parts.end());
    return true;
  }

  /// Sorts the turning points of one piece. Their brackets must be disjoint; else an offset where they are
  /// not.
  std::optional<double> order(std::size_t begin) {
    const auto first = found_.begin() + static_cast<std::ptrdiff_t>(begin);
    if (found_.end() - first < 2) {
      return std::nullopt;
    }
    const PieceRange range = trace_.pieces[first->piece].range;
    std::sort(first, found_.end(), [&](const TurningPoint<Ball>& a, const TurningPoint<Ball>& b) {
      return range.precedes(a.from, b.from);
    });
    for (auto point = first; point + 1 != found_.end(); ++point) {
      TurningPoint<Ball>& next = *(point + 1);
      const bool apart = range.precedes(point->to, next.from);
      if (!apart && (turn_in_a_fold(*point, next) || turn_in_one_point(*point, next))) {
        next.parameters.insert(next.parameters.begin(), point->parameters.begin(), point->parameters.end());
        for (std::size_t j = 0; j < 4; ++j) {
          next.box[j] = hull(point->box[j], next.box[j]);
        }
        next.from = point->from;
        next.to = later(range, point->to, next.to);
        point->parameters.clear();
        continue;
      }
      if (!apart) {
        const double at = 0.5 * (point->from + next.to);
        fail(point_at(trace_.pieces[point->piece].tube, at),
             "turning points with respect to two parameters cannot be separated");
        return at;
      }
    }
    found_.erase(std::remove_if(first, found_.end(),
                                [](const TurningPoint<Ball>& point) { return point.parameters.empty(); }),
                 found_.end());
    return std::nullopt;
  }

  static Ball hull(const Ball& a, const Ball& b) {
    const double distance = (a.midpoint() - b.midpoint()).upper_magnitude();
    return a.widened(distance + b.radius());
  }

  /// Both parameters of one patch turn where the other one, in a plane, folds: each turns once between the
  /// ends of both brackets, and the normal, a factor of both components of T, changes its sign there.
  bool turn_in_a_fold(const TurningPoint<Ball>& a, const TurningPoint<Ball>& b) const {
    if (a.parameters.size() != 1 || b.parameters.size() != 1 || a.parameters[0] / 2 != b.parameters[0] / 2) {
      return false;
    }
    const std::size_t other = 1 - a.parameters[0] / 2;
    if (!known_.plane[other]) {
      return false;
    }
    const Tube<Ball>& tube = trace_.pieces[a.piece].tube;
    const PieceRange& range = trace_.pieces[a.piece].range;
    const auto sign = [&](double tau) {
      const Expansion<Ball> at(system_, point_at(tube, tau));
      const TaylorNet<Ball>& net = other == 0 ? at.x : at.y;
      return cross(net[3], net[1])[*known_.plane[other]].certain_sign();
    };
    const double from = range.precedes(a.from, b.from) ? a.from : b.from;
    return sign(from) * sign(later(range, a.to, b.to)) < 0;
  }

  static double later(const PieceRange& range, double a, double b) { return range.precedes(a, b) ? b : a; }

  /// On the tube each parameter turns at most once: in a point where both are known to turn, if the tube
  /// holds it.
  bool turn_in_one_point(const TurningPoint<Ball>& a, const TurningPoint<Ball>& b) const {
    if (!known_.common_zero) {
      return false;
    }
    ParameterBox where;
    for (std::size_t j = 0; j < 4; ++j) {
      where[j] = hull(a.box[j], b.box[j]).interval();
    }
    for (const std::size_t i : a.parameters) {
      for (const std::size_t j : b.parameters) {
        const auto at = known_.common_zero(where, i, j);
        if (at && contains(trace_.pieces[a.piece].tube, enclosing(*at))) {
          return true;
        }
      }
    }
    return false;
  }

  static BallPoint<Ball> enclosing(const ParameterBox& box) {
    return {Ball::enclosing(box[0]), Ball::enclosing(box[1]), Ball::enclosing(box[2]),
            Ball::enclosing(box[3])};
  }

  void fail(const BallPoint<Ball>& at, const char* why) {
    failure_ = {{at[0].approximation(), at[1].approximation(), at[2].approximation(), at[3].approximation()},
                why};
  }

  const PairSystem<Ball>& system_;
  Trace<Ball>& trace_;
  const std::array<std::size_t, 4>& coincident_;
  const KnownTangent& known_;
  TurningPoints<Ball> found_;
  int magnified_ = 0;
  TraceFailure failure_;
  bool hopeless_ = false;  // no shorter tube would help
};

}  // namespace

template <class Ball>
std::variant<TurningPoints<Ball>, TraceFailure> find_turning_points(
    const PairSystem<Ball>& system, Trace<Ball>& trace, const std::array<std::size_t, 4>& coincident,
    const KnownTangent& known) {
  return TurningSearch<Ball>(system, trace, coincident, known).run();
}

template <class Ball>
bool may_be_constant(const Trace<Ball>& trace, std::size_t parameter) {
  return std::none_of(trace.pieces.begin(), trace.pieces.end(),
                      [&](const Piece<Ball>& piece) { return is_monotone(piece, parameter); });
}

#define EXSECT_INSTANTIATE_TURNING(Ball)                                                              \
  template std::variant<TurningPoints<Ball>, TraceFailure> find_turning_points(                       \
      const PairSystem<Ball>&, Trace<Ball>&, const std::array<std::size_t, 4>&, const KnownTangent&); \
  template bool may_be_constant(const Trace<Ball>&, std::size_t);

EXSECT_INSTANTIATE_TURNING(DoubleBall)
EXSECT_INSTANTIATE_TURNING(DoubleDoubleBall)
EXSECT_INSTANTIATE_TURNING(ArbBall<256>)
EXSECT_INSTANTIATE_TURNING(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_TURNING

}  // namespace exsect
