#include "self/chart_turning.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "self/pair_rates.h"
#include "trace/split_pieces.h"
#include "trace/tube_points.h"

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

template <class Ball>
class ChartTurningSearch {
 public:
  ChartTurningSearch(const Charts<Ball>& charts, ChartTrace<Ball>& trace,
                     const std::array<std::size_t, 4>& coincident, const StopRequest& stop)
      : charts_(charts), trace_(trace), coincident_(coincident), stop_(stop) {}

  std::optional<TraceFailure> run() {
    if (!split()) {
      return failure_;
    }
    for (std::size_t k = 0; k < trace_.pieces.size(); ++k) {
      const std::size_t before = trace_.turning.size();
      if (!trace_.pieces[k].monotone && !search(k)) {
        return failure_;
      }
      if (!order(before)) {
        return failure_;
      }
    }
    return std::nullopt;
  }

 private:
  /// Parameter j of the trace is parameter own(j) of t > 0 in the chart.
  static std::size_t own(const ChartPiece<Ball>& piece, std::size_t j) {
    return piece.exchanged ? (j + 2) % 4 : j;
  }

  /// Each parameter is monotone or turns at most once on the piece.
  static bool is_simple(const ChartPiece<Ball>& piece) {
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

  bool split() {
    const auto part_of = [this](const ChartPiece<Ball>& piece, double from, double to) {
      return part(piece, from, to);
    };
    const auto failure =
        split_pieces(trace_.pieces, std::numeric_limits<std::size_t>::max(), is_simple, part_of);
    if (failure) fail(failure->piece, point_at(failure->piece.tube, failure->at), failure->why);
    return !failure;
  }

  std::optional<ChartPiece<Ball>> part(const ChartPiece<Ball>& piece, double from, double to) const {
    const BallPoint<Ball> centre = point_at(piece.tube, 0.5 * (from + to));
    const BallPoint<Ball> start = point_at(piece.tube, from);
    const BallPoint<Ball> end = point_at(piece.tube, to);
    const double radius = larger_bound(largest_radius(centre), largest_radius(start), largest_radius(end));
    const std::size_t axis = piece.tube.axis;
    const double length = std::fabs(to - from);
    const auto tube =
        certify_chart_tube(chart_of(charts_, piece.chart), centre, axis, 0.505 * length + 2 * radius,
                           std::max(4 * radius, kChartTubeRoom * length));
    if (!tube || !contains(*tube, centre) || !contains(*tube, start) || !contains(*tube, end)) {
      return std::nullopt;
    }
    const auto range = PieceRange::between(start[axis] - tube->centre[axis], end[axis] - tube->centre[axis]);
    if (!range || range->direction() != piece.range.direction()) {
      return std::nullopt;
    }
    return ChartPiece<Ball>{piece.chart, piece.exchanged, false, *tube, *range};
  }

  /// The signs of the derivatives of the parameters with respect to the tube's offset.
  std::array<int, 4> rate_signs(const ChartPiece<Ball>& piece, double tau) const {
    const BallPoint<Ball> p = point_at(piece.tube, tau);
    if (!p[3].is_positive()) {
      return {};
    }
    const BallPoint<Ball> tangent = tangent_at(chart_of(charts_, piece.chart), p);
    const BallPoint<Ball> rates = pair_rates(piece.chart, p, tangent);
    const int along = tangent[piece.tube.axis].certain_sign();
    std::array<int, 4> signs;
    for (std::size_t j = 0; j < 4; ++j) {
      signs[j] = rates[own(piece, j)].certain_sign() * along;
    }
    return signs;
  }

  bool search(std::size_t k) {
    const ChartPiece<Ball> piece = trace_.pieces[k];
    if (is_stopped(stop_)) {
      fail(piece, point_at(piece.tube, piece.range.from()), "the work cap was reached");
      return false;
    }
    const std::array<int, 4> first = rate_signs(piece, piece.range.from());
    const std::array<int, 4> last = rate_signs(piece, piece.range.to());
    for (std::size_t j = 0; j < 4; ++j) {
      if (j >= 2 && coincident_[j] != j) {
        continue;
      }
      if (first[j] == 0 || last[j] == 0) {
        fail(piece, point_at(piece.tube, first[j] == 0 ? piece.range.from() : piece.range.to()),
             "a turning point cannot be separated from the end of a step");
        return false;
      }
      if (first[j] != last[j]) {
        bracket(k, j, first[j]);
      }
    }
    return true;
  }

  /// Bisection while the sign in the middle is certain.
  void bracket(std::size_t k, std::size_t j, int first_sign) {
    const ChartPiece<Ball>& piece = trace_.pieces[k];
    double from = piece.range.from();
    double to = piece.range.to();
    for (const double fraction : {0.5, 0.4853}) {
      for (int i = 0; i < 60; ++i) {
        const double middle = from + fraction * (to - from);
        const int sign = rate_signs(piece, middle)[j];
        if (sign == 0 || middle == from || middle == to) {
          break;
        }
        (sign == first_sign ? from : to) = middle;
      }
    }
    std::vector<std::size_t> parameters = {j};
    if (coincident_[j] != j) {
      parameters.push_back(coincident_[j]);
    }
    trace_.turning.push_back({parameters, k, from, to, box_between(piece.tube, from, to)});
  }

  /// Sorts the turning points of one piece; their brackets must be disjoint.
  bool order(std::size_t begin) {
    const auto first = trace_.turning.begin() + static_cast<std::ptrdiff_t>(begin);
    if (trace_.turning.end() - first < 2) {
      return true;
    }
    const ChartPiece<Ball>& piece = trace_.pieces[first->piece];
    std::sort(first, trace_.turning.end(),
              [&](const ChartTurningPoint<Ball>& a, const ChartTurningPoint<Ball>& b) {
                return piece.range.precedes(a.from, b.from);
              });
    for (auto point = first; point + 1 != trace_.turning.end(); ++point) {
      if (!piece.range.precedes(point->to, (point + 1)->from)) {
        fail(piece, point->box, "turning points with respect to two parameters cannot be separated");
        return false;
      }
    }
    return true;
  }

  void fail(const ChartPiece<Ball>& piece, const BallPoint<Ball>& at, const char* why) {
    const BallPoint<Ball> pair = at[3].is_positive() ? pair_on(piece, at) : BallPoint<Ball>{};
    failure_ = {
        {pair[0].approximation(), pair[1].approximation(), pair[2].approximation(), pair[3].approximation()},
        why};
  }

  const Charts<Ball>& charts_;
  ChartTrace<Ball>& trace_;
  const std::array<std::size_t, 4>& coincident_;
  const StopRequest& stop_;
  TraceFailure failure_;
};

}  // namespace

template <class Ball>
std::optional<TraceFailure> find_chart_turning_points(const Charts<Ball>& charts, ChartTrace<Ball>& trace,
                                                      const std::array<std::size_t, 4>& coincident,
                                                      const StopRequest& stop) {
  return ChartTurningSearch<Ball>(charts, trace, coincident, stop).run();
}

#define EXSECT_INSTANTIATE_CHART_TURNING(Ball)                    \
  template std::optional<TraceFailure> find_chart_turning_points( \
      const Charts<Ball>&, ChartTrace<Ball>&, const std::array<std::size_t, 4>&, const StopRequest&);

EXSECT_INSTANTIATE_CHART_TURNING(DoubleBall)
EXSECT_INSTANTIATE_CHART_TURNING(ArbBall<256>)
#undef EXSECT_INSTANTIATE_CHART_TURNING

}  // namespace exsect
