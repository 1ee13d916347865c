#include "self/cusp_arc.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "self/pair_rates.h"
#include "trace/enclose.h"
#include "trace/preconditioned_newton.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

constexpr std::size_t kAxisW = 3;
constexpr double kWorstCuspContraction = 0.5;
template <class Ball>
constexpr double kLeastGate = 0x1p-60;
template <>
inline constexpr double kLeastGate<ArbBall<256>> = 0x1p-230;

/// The magnitude of z_j over the tube is at most |p_j| plus this.
template <class Ball>
double reach_of(const ChartTube<Ball>& tube, std::size_t j) {
  return (std::fabs(tube.slope[j]) * tube.reach + tube.halfwidth) * kSlack;
}

template <class Ball>
double largest_slope(const ChartTube<Ball>& tube, std::size_t j) {
  return std::fabs(tube.slope[j]) + tube.slope_error[j];
}

/// U +- t (j = 0) or V +- m t (j = 1) stays in (0,1) for all w in [0, w_end].
template <class Ball>
bool stays_inside(const ChartTube<Ball>& tube, std::size_t j, double w_end) {
  const double t = std::sqrt(w_end) * kSlack;
  const Ball m = tube.centre[2].widened(reach_of(tube, 2));
  const double span = j == 0 ? t : t * m.upper_magnitude();
  const Ball range = tube.centre[j].widened((reach_of(tube, j) + span) * kSlack);
  return range.is_positive() && (Ball(1) - range).is_positive();
}

/// For U or V on a side at w = 0: its distance from there, at most |U'| w, is less than t (or |m| t) for 0 <
/// w
/// <= w_end, so that one point of the pair is outside.
template <class Ball>
bool leaves_side(const ChartTube<Ball>& tube, std::size_t j, double w_end) {
  const double t = std::sqrt(w_end) * kSlack;
  const Ball m = tube.centre[2].widened(reach_of(tube, 2));
  return largest_slope(tube, j) * t < (j == 0 ? 1 : m.lower_magnitude()) * kReduced;
}

/// With w = t^2: d(U +- t)/dt = 2t U' +- 1 or d(V +- m t)/dt = 2t V' +- (m + 2 w m') does not vanish for t <=
/// sqrt(w_end) (7.6).
template <class Ball>
bool is_monotone(const ChartTube<Ball>& tube, std::size_t j, double w_end) {
  const double t = std::sqrt(w_end) * kSlack;
  const Ball m = tube.centre[2].widened(reach_of(tube, 2));
  return j == 0 ? 2 * t * largest_slope(tube, 0) < 1 - 0x1p-40
                : 2 * t * largest_slope(tube, 1) + 2 * w_end * largest_slope(tube, 2) <
                      m.lower_magnitude() * kReduced;
}

/// Whether the tube up to w_end leaves the domain at once, stays in it properly, or neither is proved.
enum class Course { leaves, stays, unknown };

/// CuspArc::across
template <class Ball>
std::array<int, 2> crossed_sides(const ChartTube<Ball>& tube, const CuspPlace& place, double w_end) {
  std::array<int, 2> across{};
  for (std::size_t j = 0; j < 2; ++j) {
    if (place.side[j] && !(place.folded && j == 1) && leaves_side(tube, j, w_end)) {
      across[j] = j == 0 || tube.centre[2].is_positive() ? 1 : -1;
    }
  }
  return across;
}

template <class Ball>
Course course(const ChartTube<Ball>& tube, const CuspPlace& place, double w_end) {
  if (crossed_sides(tube, place, w_end) != std::array<int, 2>{}) {
    return Course::leaves;
  }
  bool stays = true;
  for (std::size_t j = 0; j < 2; ++j) {
    if (place.folded && j == 1) {  // V is constant, on a side or not
      stays = stays && (place.side[1] || stays_inside(tube, 1, w_end));
    } else if (place.side[j]) {
      stays = false;
    } else {
      stays = stays && stays_inside(tube, j, w_end) && is_monotone(tube, j, w_end);
    }
  }
  return stays ? Course::stays : Course::unknown;
}

template <class Ball>
std::optional<ChartTube<Ball>> tube_to(const ChartSystem<Ball>& system, const ChartCusp<Ball>& cusp,
                                       double w_end) {
  BallPoint<Ball> guess;
  for (std::size_t j = 0; j < 3; ++j) {
    guess[j] = cusp.at[j] + Ball(0.5 * w_end * cusp.tube.slope[j]);
  }
  guess[kAxisW] = Ball(0.5 * w_end);
  const auto centre = newton_corrected(system, guess, kAxisW, 4);
  if (!centre) {
    return std::nullopt;
  }
  auto tube = certify_tube(system, *centre, kAxisW, 0.53 * w_end,
                           std::max(4 * largest_radius(cusp.at), kChartTubeRoom * w_end));
  if (!tube || tube->contraction > kWorstCuspContraction || !contains(*tube, cusp.at)) {
    return std::nullopt;
  }
  return tube;
}

/// The point of the chart over a cuspidal point (U,V): m from x_u + m x_v = 0. Empty if x_v may vanish.
template <class Ball>
std::optional<BallPoint<Ball>> cusp_over(const ChartSystem<Ball>& system, const Ball& u, const Ball& v) {
  const ChartNet<Ball, 2> taylor = system.taylor({u, v, Ball(), Ball()});
  const BallVector<Ball>& x_u = taylor[0];
  const BallVector<Ball>& x_v = taylor[chart_strides(2)[2]];
  std::size_t k = 0;
  for (std::size_t c = 1; c < 3; ++c) {
    k = x_v[c].lower_magnitude() > x_v[k].lower_magnitude() ? c : k;
  }
  if (x_v[k].certain_sign() == 0) {
    return std::nullopt;
  }
  return BallPoint<Ball>{u, v, -x_u[k] * reciprocal(x_v[k]), Ball()};
}

template <class Ball>
Ball enclose(const RealAlgebraic& value, const Rational& width) {
  return value.is_rational() ? Ball::enclosing(value.rational())
                             : Ball::enclosing(value.refined_to(width).interval());
}

}  // namespace

template <class Ball>
CuspPlace exact_place(const ChartSystem<Ball>& system, const ChartCusp<Ball>& cusp,
                      const SpecialCusps& special, const Rational& width) {
  const std::size_t own = system.chart() == Chart::first ? 0 : 1;
  CuspPlace place;
  for (const FoldedLine& line : special.folded[own]) {
    const TriangularPoint at = line.turn.refined_to(width);
    const BallPoint<Ball> point = {Ball::enclosing(at.r_interval()), Ball::enclosing(at.s().interval()),
                                   Ball(), Ball()};
    if (contains(cusp.tube, point)) {
      return {true, line.side};
    }
  }
  for (std::size_t j = 0; j < 2; ++j) {
    for (const SideCusp& side : special.on_side[j == 0 ? own : 1 - own]) {
      const Ball at = enclose<Ball>(side.at, width);
      const Ball fixed(side.side);
      const auto point = j == 0 ? cusp_over(system, fixed, at) : cusp_over(system, at, fixed);
      if (point && contains(cusp.tube, *point)) {
        place.side[j] = side.side;
      }
    }
  }
  return place;
}

template <class Ball>
std::optional<CuspArc<Ball>> cusp_arc(const ChartSystem<Ball>& system, const ChartCusp<Ball>& cusp,
                                      const CuspPlace& place) {
  constexpr double kFirst = 0x1p-4;
  for (double w_end = kFirst; w_end >= kLeastGate<Ball>; w_end *= 0.5) {
    const auto tube = tube_to(system, cusp, w_end);
    const Course found = tube ? course(*tube, place, w_end) : Course::unknown;
    if (found == Course::unknown) {
      continue;
    }
    return CuspArc<Ball>{system.chart(), place, crossed_sides(*tube, place, w_end), *tube, cusp.at, w_end};
  }
  return std::nullopt;
}

template <class Ball>
bool passes_through(const CuspArc<Ball>& arc, Chart chart, const BallPoint<Ball>& point) {
  if (chart == arc.chart) {
    return contains(arc.tube, point);
  }
  return point[2].certain_sign() != 0 && contains(arc.tube, in_other_chart(point));
}

#define EXSECT_INSTANTIATE_CUSP_ARC(Ball)                                                               \
  template CuspPlace exact_place(const ChartSystem<Ball>&, const ChartCusp<Ball>&, const SpecialCusps&, \
                                 const Rational&);                                                      \
                                                                                                        \
  template std::optional<CuspArc<Ball>> cusp_arc(const ChartSystem<Ball>&, const ChartCusp<Ball>&,      \
                                                 const CuspPlace&);                                     \
  template bool passes_through(const CuspArc<Ball>&, Chart, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_CUSP_ARC(DoubleBall)
EXSECT_INSTANTIATE_CUSP_ARC(ArbBall<256>)
#undef EXSECT_INSTANTIATE_CUSP_ARC

}  // namespace exsect
