#include "self/chart_trace.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "self/pair_rates.h"
#include "trace/preconditioned_newton.h"
#include "trace/steps.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

constexpr double kHandOver = 0x1p-8;  // w from which on the pairs are well apart
constexpr double kSwitchChart = 1.5;  // |m|

/// All pairs over the box, which has w > 0, are inside the domain, not on its boundary.
template <class Ball>
bool is_inside(Chart chart, const BallPoint<Ball>& box) {
  if (!box[3].is_positive()) {
    return false;
  }
  const BallPoint<Ball> pair = pair_of(chart, box);
  return std::all_of(pair.begin(), pair.end(),
                     [](const Ball& c) { return c.is_positive() && (Ball(1) - c).is_positive(); });
}

/// A box around the whole tube, or around its arc between two offsets.
template <class Ball>
BallPoint<Ball> box_of(const ChartTube<Ball>& tube) {
  BallPoint<Ball> box;
  for (std::size_t j = 0; j < 4; ++j) {
    const double width = std::fabs(tube.slope[j]) * tube.reach + (j == tube.axis ? 0 : tube.halfwidth);
    box[j] = tube.centre[j].widened(width * kSlack);
  }
  return box;
}

template <class Ball>
class ChartTracer {
 public:
  ChartTracer(const Charts<Ball>& charts, const std::vector<CuspArc<Ball>>& cusps, int start,
              const StopRequest& stop)
      : charts_(charts), cusps_(cusps), stop_(stop) {
    const CuspArc<Ball>& cusp = cusps[static_cast<std::size_t>(start)];
    const double half = 0.5 * cusp.gate_w;
    trace_.start = start;
    if (const auto range = PieceRange::between(-half, half)) {
      trace_.pieces.push_back({cusp.chart, false, true, cusp.tube, *range});
    }
    chart_ = cusp.chart;
    position_ = point_at(cusp.tube, half);
    sign_ = tangent_at(chart_of(charts_, chart_), position_)[3].certain_sign();
    extend_ = sign_ != 0 && !cusp.place.folded;
  }

  ChartTrace<Ball> run() {
    while (extend_ && trace_.pieces.size() < kChartSteps.most_pieces &&
           !(position_[3] - Ball(kHandOver)).is_positive()) {
      if (is_stopped(stop_) || reached_cusp() || !advance()) {
        break;
      }
      switch_chart();
    }
    set_gate();
    return std::move(trace_);
  }

 private:
  bool advance() {
    const BallPoint<Ball> tangent = tangent_at(chart_of(charts_, chart_), position_);
    const std::size_t axis = steepest_axis(tangent);
    const int direction = sign_ * tangent[axis].certain_sign();
    if (direction == 0) {
      return false;
    }
    const double least = std::min(kChartSteps.least, 0x1p-10 * position_[3].lower_magnitude());
    for (; step_ >= least; step_ *= 0.6) {
      const auto tube = next_tube(tangent, axis, direction);
      if (!tube || !is_inside(chart_, box_of(*tube))) {
        continue;
      }
      const double to = 0.5 * direction * step_;
      const auto range = PieceRange::between(offset(*tube, position_), Ball(to));
      if (!range || range->direction() != direction) {
        continue;
      }
      trace_.pieces.push_back({chart_, exchanged_, false, *tube, *range});
      position_ = point_at(*tube, to);
      step_ = std::min(
          {2 * step_, step_ * std::max(0.5, kChartSteps.good / tube->contraction), kChartSteps.longest});
      return true;
    }
    return false;
  }

  std::optional<ChartTube<Ball>> next_tube(const BallPoint<Ball>& tangent, std::size_t axis,
                                           int direction) const {
    const ChartSystem<Ball>& system = chart_of(charts_, chart_);
    BallPoint<Ball> guess;
    for (std::size_t j = 0; j < 4; ++j) {
      const double slope = j == axis ? 1 : tangent[j].approximation() / tangent[axis].approximation();
      guess[j] = (position_[j] + Ball(0.5 * direction * step_ * slope)).midpoint();
    }
    const auto centre = newton_corrected(system, guess, axis, 2);
    if (!centre) {
      return std::nullopt;
    }
    const double radius = largest_radius(position_);
    auto tube = certify_tube(system, *centre, axis, 0.51 * step_ + 2 * radius,
                             std::max(4 * radius, kChartTubeRoom * step_));
    if (!tube || tube->contraction > kChartSteps.worst || !contains(*tube, position_)) {
      return std::nullopt;
    }
    return tube;
  }

  /// On another cuspidal point's tube the curve is that tube's arc.
  bool reached_cusp() {
    for (std::size_t k = 0; k < cusps_.size(); ++k) {
      const CuspArc<Ball>& cusp = cusps_[k];
      if (static_cast<int>(k) == trace_.start || !passes_through(cusp, chart_, position_)) {
        continue;
      }
      const bool same_chart = cusp.chart == chart_;
      const Ball w = same_chart ? position_[3] : in_other_chart(position_)[3];
      if (!(Ball(cusp.gate_w) - w).is_positive()) {
        continue;
      }
      const bool flips = !same_chart && position_[2].is_negative();
      const double half = 0.5 * cusp.gate_w;
      const auto range = PieceRange::between(w - Ball(half), Ball(-half));
      if (!range) {
        continue;
      }
      trace_.pieces.push_back({cusp.chart, exchanged_ != flips, true, cusp.tube, *range});
      trace_.end = static_cast<int>(k);
      return true;
    }
    return false;
  }

  /// t > 0 in one chart is t > 0 in the other if m > 0.
  void switch_chart() {
    if (std::fabs(position_[2].approximation()) < kSwitchChart) {
      return;
    }
    const Chart next = chart_ == Chart::first ? Chart::second : Chart::first;
    const BallPoint<Ball> image = in_other_chart(position_);
    const BallPoint<Ball> before = tangent_at(chart_of(charts_, chart_), position_);
    const BallPoint<Ball> after = tangent_at(chart_of(charts_, next), image);
    for (std::size_t j = 0; j < 2; ++j) {
      const int sign = sign_ * before[j].certain_sign() * after[1 - j].certain_sign();
      if (sign != 0) {
        exchanged_ = exchanged_ != position_[2].is_negative();
        sign_ = sign;
        chart_ = next;
        position_ = image;
        return;
      }
    }
  }

  void set_gate() {
    trace_.direction = {};
    if (trace_.end >= 0) {
      return;
    }
    trace_.gate = pair_of(chart_, position_);
    BallPoint<Ball> rates = pair_rates(chart_, position_, tangent_at(chart_of(charts_, chart_), position_));
    if (exchanged_) {
      trace_.gate = exchanged_pair(trace_.gate);
      rates = exchanged_pair(rates);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      trace_.direction[j] = sign_ * rates[j].certain_sign();
    }
  }

  const Charts<Ball>& charts_;
  const std::vector<CuspArc<Ball>>& cusps_;
  const StopRequest& stop_;
  ChartTrace<Ball> trace_;
  Chart chart_;
  bool exchanged_ = false;
  BallPoint<Ball> position_;
  int sign_;
  double step_ = kChartSteps.first;
  bool extend_;
};

}  // namespace

template <class Ball>
ChartTrace<Ball> trace_from_cusp(const Charts<Ball>& charts, const std::vector<CuspArc<Ball>>& cusps,
                                 int start, const StopRequest& stop) {
  return ChartTracer<Ball>(charts, cusps, start, stop).run();
}

template <class Ball>
bool passes_through(const ChartTrace<Ball>& trace, Chart chart, const BallPoint<Ball>& point) {
  const bool invertible = point[2].certain_sign() != 0;
  const BallPoint<Ball> other = invertible ? in_other_chart(point) : point;
  return std::any_of(trace.pieces.begin(), trace.pieces.end(), [&](const ChartPiece<Ball>& piece) {
    return piece.chart == chart ? contains(piece.tube, point) : invertible && contains(piece.tube, other);
  });
}

#define EXSECT_INSTANTIATE_CHART_TRACE(Ball)                                                             \
  template ChartTrace<Ball> trace_from_cusp(const Charts<Ball>&, const std::vector<CuspArc<Ball>>&, int, \
                                            const StopRequest&);                                         \
  template bool passes_through(const ChartTrace<Ball>&, Chart, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_CHART_TRACE(DoubleBall)
EXSECT_INSTANTIATE_CHART_TRACE(ArbBall<256>)
#undef EXSECT_INSTANTIATE_CHART_TRACE

}  // namespace exsect
