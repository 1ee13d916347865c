#include "self_chart_trace.h"

#include <algorithm>
#include <cmath>

namespace exsect {

namespace {

constexpr double kHandOver = 0x1p-8;  // w from which on the pairs are well apart
constexpr double kFirstStep = 0x1p-6;
constexpr double kLeastStep = 0x1p-24;  // or a small part of w, if that is less
constexpr double kLongestStep = 0.25;
constexpr double kGoodContraction = 0.25;  // steps are chosen to end near this value
constexpr double kWorstContraction = 0.5;
constexpr double kSwitchChart = 1.5;  // |m|
// Half width of a tube for each unit of its length, so that enclosures of its points fit in.
constexpr double kRoom = 0x1p-8;
constexpr int kMostPieces = 2000;

template <class Ball>
double largest_radius(const BallPoint<Ball>& box) {
  return std::max({box[0].radius(), box[1].radius(), box[2].radius(), box[3].radius()});
}

/// The kernel of DH at a point, a continuous field on a chart.
template <class Ball>
BallPoint<Ball> tangent_at(const ChartSystem<Ball>& system, const BallPoint<Ball>& p) {
  const ChartNet<Ball, 2> taylor = system.taylor(p);
  std::array<BallVector<Ball>, 4> column;
  for (std::size_t j = 0; j < 4; ++j) {
    column[j] = taylor[chart_strides(2)[j]];
  }
  const BallVector<Ball> last = cross(column[2], column[3]);
  const BallVector<Ball> first = cross(column[0], column[1]);
  return {dot(column[1], last), -dot(column[0], last), dot(first, column[3]), -dot(first, column[2])};
}

/// 2 t times the derivatives of u1, v1, u2, v2 (for t > 0) for the derivative d of (U,V,m,w) at p.
template <class Ball>
BallPoint<Ball> pair_rates(Chart chart, const BallPoint<Ball>& p, const BallPoint<Ball>& d) {
  const Ball t2 = Ball(2) * square_root(p[3]);
  const Ball u = t2 * d[0];
  const Ball v = t2 * d[1];
  const Ball dv = p[2] * d[3] + Ball(2) * p[3] * d[2];
  return chart == Chart::first ? BallPoint<Ball>{u + d[3], v + dv, u - d[3], v - dv}
                               : BallPoint<Ball>{v + dv, u + d[3], v - dv, u - d[3]};
}

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
    box[j] = tube.centre[j].widened(width * (1 + 0x1p-40));
  }
  return box;
}
template <class Ball>
BallPoint<Ball> box_between(const ChartTube<Ball>& tube, double from, double to) {
  const double middle = 0.5 * (from + to);
  // The second term covers the rounding of `middle` and of the difference.
  const double half =
      0.5 * std::fabs(to - from) + 0x1p-50 * std::max(std::fabs(from), std::fabs(to)) + 0x1p-1000;
  BallPoint<Ball> box = point_at(tube, middle);
  for (std::size_t j = 0; j < 4; ++j) {
    box[j] = box[j].widened(half * (std::fabs(tube.slope[j]) + tube.slope_error[j]) * (1 + 0x1p-40));
  }
  return box;
}

template <class Ball>
class ChartTracer {
 public:
  ChartTracer(const Charts<Ball>& charts, const std::vector<CuspArc<Ball>>& cusps, int start)
      : charts_(charts), cusps_(cusps) {
    const CuspArc<Ball>& cusp = cusps[static_cast<std::size_t>(start)];
    const double half = 0.5 * cusp.gate_w;
    trace_.start = start;
    trace_.pieces.push_back({cusp.chart, false, true, cusp.tube, -half, half});
    chart_ = cusp.chart;
    position_ = point_at(cusp.tube, half);
    sign_ = tangent_at(chart_of(charts_, chart_), position_)[3].certain_sign();
    extend_ = sign_ != 0 && !cusp.place.folded;
  }

  ChartTrace<Ball> run() {
    while (extend_ && trace_.pieces.size() < kMostPieces && !(position_[3] - Ball(kHandOver)).is_positive()) {
      if (reached_cusp() || !advance()) {
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
    std::size_t axis = 0;
    for (std::size_t j = 1; j < 4; ++j) {
      axis = std::fabs(tangent[j].approximation()) > std::fabs(tangent[axis].approximation()) ? j : axis;
    }
    const int direction = sign_ * tangent[axis].certain_sign();
    if (direction == 0) {
      return false;
    }
    const double least = std::min(kLeastStep, 0x1p-10 * position_[3].lower_magnitude());
    for (; step_ >= least; step_ *= 0.6) {
      const auto tube = next_tube(tangent, axis, direction);
      if (!tube || !is_inside(chart_, box_of(*tube))) {
        continue;
      }
      const double to = 0.5 * direction * step_;
      const Ball here = position_[axis] - tube->centre[axis];
      trace_.pieces.push_back({chart_, exchanged_, false, *tube, here.approximation(), to});
      position_ = point_at(*tube, to);
      step_ =
          std::min({2 * step_, step_ * std::max(0.5, kGoodContraction / tube->contraction), kLongestStep});
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
    auto tube = certify_chart_tube(system, *centre, axis, 0.51 * step_ + 2 * radius,
                                   std::max(4 * radius, kRoom * step_));
    if (!tube || tube->contraction > kWorstContraction || !contains(*tube, position_)) {
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
      trace_.pieces.push_back(
          {cusp.chart, exchanged_ != flips, true, cusp.tube, (w - Ball(half)).approximation(), -half});
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
  ChartTrace<Ball> trace_;
  Chart chart_;
  bool exchanged_ = false;
  BallPoint<Ball> position_;
  int sign_;
  double step_ = kFirstStep;
  bool extend_;
};

template <class Ball>
class ChartTurningSearch {
 public:
  ChartTurningSearch(const Charts<Ball>& charts, ChartTrace<Ball>& trace,
                     const std::array<std::size_t, 4>& coincident)
      : charts_(charts), trace_(trace), coincident_(coincident) {}

  std::optional<TraceFailure> run() {
    if (!split_pieces()) {
      return failure_;
    }
    for (std::size_t k = 0; k < trace_.pieces.size(); ++k) {
      const std::size_t before = trace_.turning.size();
      for (std::size_t j = 0; j < 4 && !trace_.pieces[k].monotone; ++j) {
        if ((j < 2 || coincident_[j] == j) && !search(k, j)) {
          return failure_;
        }
      }
      if (!order(before)) {
        return failure_;
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr int kDeepestSplit = 40;

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
    const BallPoint<Ball> box = box_between(tube, piece.from, piece.to);
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

  bool split_pieces() {
    std::vector<ChartPiece<Ball>> done;
    std::vector<std::pair<ChartPiece<Ball>, int>> waiting;
    for (auto piece = trace_.pieces.rbegin(); piece != trace_.pieces.rend(); ++piece) {
      waiting.emplace_back(std::move(*piece), 0);
    }
    while (!waiting.empty()) {
      auto [piece, depth] = std::move(waiting.back());
      waiting.pop_back();
      if (is_simple(piece)) {
        done.push_back(std::move(piece));
        continue;
      }
      const double middle = piece.from + 0.4853 * (piece.to - piece.from);
      const auto first = part(piece, piece.from, middle);
      const auto second = part(piece, middle, piece.to);
      if (depth >= kDeepestSplit || !first || !second) {
        fail(piece, point_at(piece.tube, middle), "two turning points are too close to be separated");
        return false;
      }
      waiting.emplace_back(*second, depth + 1);
      waiting.emplace_back(*first, depth + 1);
    }
    trace_.pieces = std::move(done);
    return true;
  }

  std::optional<ChartPiece<Ball>> part(const ChartPiece<Ball>& piece, double from, double to) const {
    const BallPoint<Ball> centre = point_at(piece.tube, 0.5 * (from + to));
    const BallPoint<Ball> start = point_at(piece.tube, from);
    const BallPoint<Ball> end = point_at(piece.tube, to);
    const double radius = std::max({largest_radius(centre), largest_radius(start), largest_radius(end)});
    const std::size_t axis = piece.tube.axis;
    const double length = std::fabs(to - from);
    const auto tube = certify_chart_tube(chart_of(charts_, piece.chart), centre, axis,
                                         0.505 * length + 2 * radius, std::max(4 * radius, kRoom * length));
    if (!tube || !contains(*tube, centre) || !contains(*tube, start) || !contains(*tube, end)) {
      return std::nullopt;
    }
    return ChartPiece<Ball>{piece.chart,
                            piece.exchanged,
                            false,
                            *tube,
                            (start[axis] - tube->centre[axis]).approximation(),
                            (end[axis] - tube->centre[axis]).approximation()};
  }

  /// The sign of the derivative of parameter j with respect to the tube's offset.
  int rate_sign(const ChartPiece<Ball>& piece, double tau, std::size_t j) const {
    const BallPoint<Ball> p = point_at(piece.tube, tau);
    if (!p[3].is_positive()) {
      return 0;
    }
    const BallPoint<Ball> tangent = tangent_at(chart_of(charts_, piece.chart), p);
    return pair_rates(piece.chart, p, tangent)[own(piece, j)].certain_sign() *
           tangent[piece.tube.axis].certain_sign();
  }

  bool search(std::size_t k, std::size_t j) {
    const ChartPiece<Ball>& piece = trace_.pieces[k];
    const int first = rate_sign(piece, piece.from, j);
    const int last = rate_sign(piece, piece.to, j);
    if (first == 0 || last == 0) {
      fail(piece, point_at(piece.tube, first == 0 ? piece.from : piece.to),
           "a turning point cannot be separated from the end of a step");
      return false;
    }
    if (first != last) {
      bracket(k, j, first);
    }
    return true;
  }

  /// Bisection while the sign in the middle is certain.
  void bracket(std::size_t k, std::size_t j, int first_sign) {
    const ChartPiece<Ball>& piece = trace_.pieces[k];
    double from = piece.from;
    double to = piece.to;
    for (const double fraction : {0.5, 0.4853}) {
      for (int i = 0; i < 60; ++i) {
        const double middle = from + fraction * (to - from);
        const int sign = rate_sign(piece, middle, j);
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
    const bool forward = piece.to > piece.from;
    std::sort(first, trace_.turning.end(),
              [&](const ChartTurningPoint<Ball>& a, const ChartTurningPoint<Ball>& b) {
                return forward ? a.from < b.from : a.from > b.from;
              });
    for (auto point = first; point + 1 != trace_.turning.end(); ++point) {
      if (forward ? !(point->to < (point + 1)->from) : !(point->to > (point + 1)->from)) {
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
  TraceFailure failure_;
};

}  // namespace

template <class Ball>
ChartTrace<Ball> trace_from_cusp(const Charts<Ball>& charts, const std::vector<CuspArc<Ball>>& cusps,
                                 int start) {
  return ChartTracer<Ball>(charts, cusps, start).run();
}

template <class Ball>
std::optional<TraceFailure> find_chart_turning_points(const Charts<Ball>& charts, ChartTrace<Ball>& trace,
                                                      const std::array<std::size_t, 4>& coincident) {
  return ChartTurningSearch<Ball>(charts, trace, coincident).run();
}

template <class Ball>
bool passes_through(const ChartTrace<Ball>& trace, Chart chart, const BallPoint<Ball>& point) {
  const bool invertible = point[2].certain_sign() != 0;
  const BallPoint<Ball> other = invertible ? in_other_chart(point) : point;
  return std::any_of(trace.pieces.begin(), trace.pieces.end(), [&](const ChartPiece<Ball>& piece) {
    return piece.chart == chart ? contains(piece.tube, point) : invertible && contains(piece.tube, other);
  });
}

#define EXSECT_INSTANTIATE_CHART_TRACE(Ball)                                                              \
  template ChartTrace<Ball> trace_from_cusp(const Charts<Ball>&, const std::vector<CuspArc<Ball>>&, int); \
  template std::optional<TraceFailure> find_chart_turning_points(const Charts<Ball>&, ChartTrace<Ball>&,  \
                                                                 const std::array<std::size_t, 4>&);      \
  template bool passes_through(const ChartTrace<Ball>&, Chart, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_CHART_TRACE(DoubleBall)
EXSECT_INSTANTIATE_CHART_TRACE(ArbBall<256>)
#undef EXSECT_INSTANTIATE_CHART_TRACE

}  // namespace exsect
