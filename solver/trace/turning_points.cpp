#include "trace/turning_points.h"

#include <algorithm>
#include <cmath>

#include "answer/parameter_box.h"
#include "trace/shorter_piece.h"
#include "trace/tube_points.h"
#include "trace/turning_search.h"

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

/// On the tubes of a pair (turning_search.h): T_j is the derivative.
template <class Ball>
class PairTurning {
 public:
  using Number = Ball;
  using Piece = exsect::Piece<Ball>;
  static constexpr std::size_t most_pieces = kMostTurningPieces<Ball>;

  PairTurning(const PairSystem<Ball>& system, Trace<Ball>& trace, const KnownTangent& known)
      : system_(system), trace_(trace), known_(known) {}

  bool is_simple(const Piece& piece) const {
    return std::all_of(all_parameters.begin(), all_parameters.end(), [&](Parameter p) {
      return !may_turn(piece, index(p)) || turns_at_most_once(piece, index(p));
    });
  }

  std::optional<Piece> part(const Piece& piece, double from, double to) const {
    return shorter_piece(system_, piece, from, to);
  }

  bool may_turn(const Piece& piece, std::size_t j) const {
    return !known_.constant[j] && !is_monotone(piece, j);
  }

  int sign_at(const Piece& piece, double tau, std::size_t j) const {
    return tangent_at(piece.tube, tau)[j].certain_sign();
  }

  double slope_at(const Piece& piece, double tau, std::size_t j) const {
    const BallPoint<Ball> t = tangent_at(piece.tube, tau);
    return t[j].approximation() / t[piece.tube.axis].approximation();
  }

  /// At an end of an open trace 0 if T_j is known to vanish there; otherwise the sign at the offset that
  /// stands for the end point must be the one at that point, so that the parameter does not turn in between,
  /// perhaps outside the domain.
  std::optional<int> end_sign(std::size_t k, std::size_t j, bool at_end) const {
    const Piece& piece = trace_.pieces[k];
    const int sign = sign_at(piece, at_end ? piece.range.to() : piece.range.from(), j);
    if (is_joint(k, at_end)) {
      return sign == 0 ? std::nullopt : std::optional(sign);
    }
    const std::optional<int> known = (at_end ? known_.at_end : known_.at_start)[j];
    return known == 0 || known == sign ? known : std::nullopt;
  }

  bool knows_end(std::size_t k, std::size_t j, bool at_end) const {
    return !is_joint(k, at_end) && (at_end ? known_.at_end : known_.at_start)[j];
  }

  double unit(const Piece& piece) const { return kUnit<Ball> > 0 ? kUnit<Ball> : 0x1p-50 * piece.tube.reach; }

  bool are_one(const TurningPoint<Ball>& a, const TurningPoint<Ball>& b) const {
    return turn_in_a_fold(a, b) || turn_in_one_point(a, b);
  }

  /// The tube is so short that doubles tell offsets apart that they could not on the piece; false if balls
  /// are no finer than doubles, or after many times.
  bool magnify(std::size_t k, double at) {
    const Piece piece = trace_.pieces[k];
    const double half = kMagnified * piece.range.length();
    if (kUnit < Ball >> 0 || !(half > kLeastMagnified<Ball>) || ++magnified_ > kMostMagnified) {
      return false;
    }
    const double last = piece.range.to();
    const std::array<double, 4> cuts = {piece.range.from(), piece.range.ahead_of(at, -half),
                                        piece.range.ahead_of(at, half), last};
    std::vector<Piece> parts;
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

  BallPoint<Ball> pair(const Piece& /*piece*/, const BallPoint<Ball>& at) const { return at; }

 private:
  BallPoint<Ball> tangent_at(const Tube<Ball>& tube, double tau) const {
    return Expansion<Ball>(system_, point_at(tube, tau)).tangent();
  }

  /// Where piece k begins, or ends, another one ends or begins.
  bool is_joint(std::size_t k, bool at_end) const {
    return trace_.start < 0 || (at_end ? k + 1 < trace_.pieces.size() : k > 0);
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

  /// On the tube each parameter turns at most once: in a point where both are known to turn, if the tube
  /// holds it.
  bool turn_in_one_point(const TurningPoint<Ball>& a, const TurningPoint<Ball>& b) const {
    if (!known_.common_zero) {
      return false;
    }
    ParameterBox where;
    for (std::size_t j = 0; j < 4; ++j) {
      where[j] = ball_hull(a.box[j], b.box[j]).interval();
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

  const PairSystem<Ball>& system_;
  Trace<Ball>& trace_;
  const KnownTangent& known_;
  int magnified_ = 0;
};

}  // namespace

template <class Ball>
std::variant<TurningPoints<Ball>, TraceFailure> find_turning_points(
    const PairSystem<Ball>& system, Trace<Ball>& trace, const std::array<std::size_t, 4>& coincident,
    const KnownTangent& known) {
  if (kUnit<Ball> == 0) {
    resolve_short_arc(system, trace);
  }
  return TurningSearch<PairTurning<Ball>>({system, trace, known}, trace.pieces, coincident, {}).run();
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
