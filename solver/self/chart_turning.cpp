#include "self/chart_turning.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "self/pair_rates.h"
#include "trace/preconditioned_newton.h"
#include "trace/shorter_piece.h"
#include "trace/turning_search.h"

namespace exsect {

namespace {

/// t times the derivatives of pair_rates for the second derivative s.
template <class Ball>
BallPoint<Ball> pair_second_rates(Chart chart, const BallPoint<Ball>& p, const BallPoint<Ball>& d,
                                  const BallPoint<Ball>& s) {
  const Ball t = square_root(p[3]);
  const Ball w2 = Ball(2) * p[3];
  const Ball u = w2 * s[0] + d[3] * d[0];
  const Ball v = w2 * s[1] + d[3] * d[1];
  const Ball du = t * s[3];
  const Ball dv = t * (Ball(3) * d[2] * d[3] + p[2] * s[3] + w2 * s[2]);
  return chart == Chart::first ? BallPoint<Ball>{u + du, v + dv, u - du, v - dv}
                               : BallPoint<Ball>{v + dv, u + du, v - dv, u - du};
}

/// On the tubes of both charts (turning_search.h).
template <class Ball>
class ChartTurning {
 public:
  using Number = Ball;
  using Piece = ChartPiece<Ball>;
  static constexpr std::size_t most_pieces = std::numeric_limits<std::size_t>::max();

  ChartTurning(const Charts<Ball>& charts, const std::vector<Piece>& pieces)
      : charts_(charts), pieces_(pieces) {}

  static bool is_simple(const Piece& piece) {
    if (piece.monotone) {
      return true;
    }
    const ChartTube<Ball>& tube = piece.tube;
    const BallPoint<Ball> box = box_between(tube, piece.range.from(), piece.range.to());
    BallPoint<Ball> d;
    BallPoint<Ball> s;
    for (std::size_t j = 0; j < 4; ++j) {
      d[j] = Ball(tube.slope[j]).widened(tube.slope_error[j]);
      s[j] = Ball(tube.second[j]).widened(tube.second_error[j]);
    }
    if (!box[3].is_positive()) {
      return false;
    }
    const BallPoint<Ball> first = pair_rates(piece.chart, box, d);
    const BallPoint<Ball> second = pair_second_rates(piece.chart, box, d, s);
    for (std::size_t j = 0; j < 4; ++j) {
      if (first[j].certain_sign() == 0 && second[j].certain_sign() == 0) {
        return false;
      }
    }
    return true;
  }

  std::optional<Piece> part(const Piece& piece, double from, double to) const {
    const BallPoint<Ball> centre = point_at(piece.tube, 0.5 * (from + to));
    const BallPoint<Ball> start = point_at(piece.tube, from);
    const BallPoint<Ball> end = point_at(piece.tube, to);
    const double radius = larger_bound(largest_radius(centre), largest_radius(start), largest_radius(end));
    const std::size_t axis = piece.tube.axis;
    const double length = std::fabs(to - from);
    const auto tube = certify_tube(chart_of(charts_, piece.chart), centre, axis, 0.505 * length + 2 * radius,
                                   std::max(4 * radius, kChartTubeRoom * length));
    const auto range =
        tube ? range_on(*tube, start, centre, end, piece.range.direction()) : std::optional<PieceRange>();
    if (!range) {
      return std::nullopt;
    }
    return Piece{piece.chart, piece.exchanged, false, *tube, *range};
  }

  bool may_turn(const Piece& piece, std::size_t /*j*/) const { return !piece.monotone; }

  int sign_at(const Piece& piece, double tau, std::size_t j) const {
    const auto [rate, along] = rates_at(piece, tau, j);
    return rate.certain_sign() * along.certain_sign();
  }

  double slope_at(const Piece& piece, double tau, std::size_t j) const {
    const auto [rate, along] = rates_at(piece, tau, j);
    return rate.approximation() / along.approximation();
  }

  /// Ends of traces are like joints.
  std::optional<int> end_sign(std::size_t k, std::size_t j, bool at_end) const {
    const PieceRange& range = pieces_[k].range;
    const int sign = sign_at(pieces_[k], at_end ? range.to() : range.from(), j);
    return sign == 0 ? std::nullopt : std::optional(sign);
  }
  static bool knows_end(std::size_t /*k*/, std::size_t /*j*/, bool /*at_end*/) { return false; }

  static double unit(const Piece& piece) { return 0x1p-50 * piece.tube.reach; }

  static bool are_one(const TurningPoint<Ball>& /*a*/, const TurningPoint<Ball>& /*b*/) { return false; }
  static bool magnify(std::size_t /*k*/, double /*at*/) { return false; }

  static BallPoint<Ball> pair(const Piece& piece, const BallPoint<Ball>& at) {
    return at[3].is_positive() ? pair_on(piece, at) : BallPoint<Ball>{};
  }

 private:
  /// The derivatives, up to one positive factor, of parameter j of the trace and of the tube's axis along the
  /// tangent field.
  std::array<Ball, 2> rates_at(const Piece& piece, double tau, std::size_t j) const {
    const BallPoint<Ball> p = point_at(piece.tube, tau);
    if (!p[3].is_positive()) {
      return {Ball(0), Ball(1)};
    }
    const BallPoint<Ball> tangent = tangent_at(chart_of(charts_, piece.chart), p);
    // Parameter j of the trace is another one of t > 0 in the chart if the piece is exchanged.
    return {pair_rates(piece.chart, p, tangent)[piece.exchanged ? (j + 2) % 4 : j], tangent[piece.tube.axis]};
  }

  const Charts<Ball>& charts_;
  const std::vector<Piece>& pieces_;
};

}  // namespace

template <class Ball>
std::optional<TraceFailure> find_chart_turning_points(const Charts<Ball>& charts, ChartTrace<Ball>& trace,
                                                      const std::array<std::size_t, 4>& coincident,
                                                      const StopRequest& stop) {
  auto found =
      TurningSearch<ChartTurning<Ball>>({charts, trace.pieces}, trace.pieces, coincident, stop).run();
  if (const auto* failure = std::get_if<TraceFailure>(&found)) return *failure;
  trace.turning = std::get<TurningPoints<Ball>>(std::move(found));
  return std::nullopt;
}

#define EXSECT_INSTANTIATE_CHART_TURNING(Ball)                    \
  template std::optional<TraceFailure> find_chart_turning_points( \
      const Charts<Ball>&, ChartTrace<Ball>&, const std::array<std::size_t, 4>&, const StopRequest&);

EXSECT_INSTANTIATE_CHART_TURNING(DoubleBall)
EXSECT_INSTANTIATE_CHART_TURNING(ArbBall<256>)
#undef EXSECT_INSTANTIATE_CHART_TURNING

}  // namespace exsect
