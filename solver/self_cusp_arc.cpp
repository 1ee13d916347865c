#include "self_cusp_arc.h"

#include <algorithm>
#include <cmath>

namespace exsect {

namespace {

constexpr std::size_t kAxisW = 3;
constexpr double kWorstContraction = 0.5;

/// The magnitude of z_j over the tube is at most |p_j| plus this.
template <class Ball>
double reach_of(const ChartTube<Ball>& tube, std::size_t j) {
  return (std::fabs(tube.slope[j]) * tube.reach + tube.halfwidth) * (1 + 0x1p-40);
}

template <class Ball>
double largest_slope(const ChartTube<Ball>& tube, std::size_t j) {
  return std::fabs(tube.slope[j]) + tube.slope_error[j];
}

/// U +- t and V +- m t stay in (0,1) for all w in [0, w_end].
template <class Ball>
bool stays_inside(const ChartTube<Ball>& tube, double w_end) {
  const double t = std::sqrt(w_end) * (1 + 0x1p-40);
  const Ball m = tube.centre[2].widened(reach_of(tube, 2));
  for (std::size_t j = 0; j < 2; ++j) {
    const double span = j == 0 ? t : t * m.upper_magnitude();
    const Ball range = tube.centre[j].widened((reach_of(tube, j) + span) * (1 + 0x1p-40));
    if (!range.is_positive() || !(Ball(1) - range).is_positive()) {
      return false;
    }
  }
  return true;
}

/// With w = t^2: d(U +- t)/dt = 2t U' +- 1 and d(V +- m t)/dt = 2t V' +- (m + 2 w m') do not vanish for t <=
/// t_end.
template <class Ball>
bool is_monotone(const ChartTube<Ball>& tube, double w_end) {
  const double t = std::sqrt(w_end) * (1 + 0x1p-40);
  const Ball m = tube.centre[2].widened(reach_of(tube, 2));
  return 2 * t * largest_slope(tube, 0) < 1 - 0x1p-40 &&
         2 * t * largest_slope(tube, 1) + 2 * w_end * largest_slope(tube, 2) <
             m.lower_magnitude() * (1 - 0x1p-40);
}

template <class Ball>
double largest_radius(const BallPoint<Ball>& box) {
  return std::max({box[0].radius(), box[1].radius(), box[2].radius(), box[3].radius()});
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
  auto tube = certify_chart_tube(system, *centre, kAxisW, 0.53 * w_end, 4 * largest_radius(cusp.at));
  if (!tube || tube->contraction > kWorstContraction || !contains(*tube, cusp.at)) {
    return std::nullopt;
  }
  return tube;
}

struct BoundedVertex {
  PolylineVertex vertex;
  double error;
};

template <class Ball>
std::array<double, 4> approximate_pair(Chart chart, const BallPoint<Ball>& p) {
  const double t = std::sqrt(std::max(0.0, p[3].approximation()));
  const double mt = p[2].approximation() * t;
  const double a = p[0].approximation();
  const double b = p[1].approximation();
  return chart == Chart::first ? std::array<double, 4>{a + t, b + mt, a - t, b - mt}
                               : std::array<double, 4>{b + mt, a + t, b - mt, a - t};
}

template <class Ball>
BoundedVertex vertex_at(const ChartSystem<Ball>& system, const BallPoint<Ball>& p, const ModelFrame& frame) {
  BoundedVertex result{};
  result.vertex.parameters = approximate_pair(system.chart(), p);
  const BallVector<Ball> position = space_point(system, p);
  double radius2 = 0;
  double rounding = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double scaled = position[c].approximation();
    const double radius =
        std::ldexp((position[c] - Ball(scaled)).upper_magnitude(), static_cast<int>(frame.exponent));
    result.vertex.point[c] = frame.origin[c] + std::ldexp(scaled, static_cast<int>(frame.exponent));
    radius2 += radius * radius;
    rounding += std::fabs(result.vertex.point[c]) * 0x1p-52;  // one sum of doubles
  }
  result.error = (std::sqrt(radius2) + rounding) * (1 + 0x1p-40) + 0x1p-1000;
  return result;
}

}  // namespace

template <class Ball>
std::optional<CuspArc<Ball>> cusp_arc(const ChartSystem<Ball>& system, const ChartCusp<Ball>& cusp) {
  constexpr double kFirst = 0x1p-4;
  constexpr double kLast = 0x1p-44;
  for (double w_end = kFirst; w_end >= kLast; w_end *= 0.5) {
    const auto tube = tube_to(system, cusp, w_end);
    if (!tube || !stays_inside(*tube, w_end) || !is_monotone(*tube, w_end)) {
      continue;
    }
    const BallPoint<Ball> gate = point_at(*tube, 0.5 * w_end);
    return CuspArc<Ball>{system.chart(), *tube, cusp.at, w_end, pair_of(system.chart(), gate)};
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

template <class Ball>
Node cusp_node(const ChartSystem<Ball>& system, const CuspArc<Ball>& arc, const ModelFrame& frame) {
  const PolylineVertex vertex = vertex_at(system, arc.cusp, frame).vertex;
  const std::size_t first = arc.chart == Chart::first ? 0 : 1;
  const RationalInterval u = arc.cusp[first].interval();
  const RationalInterval v = arc.cusp[1 - first].interval();
  Node node;
  node.id = 0;
  node.kinds = {NodeKind::cusp};
  node.box = {u, v, u, v};
  node.approx = vertex.parameters;
  node.point = vertex.point;
  return node;
}

template <class Ball>
CuspPolyline cusp_polyline(const ChartSystem<Ball>& system, const CuspArc<Ball>& arc, const ModelFrame& frame,
                           double tolerance) {
  // X(w) is smooth, so a chord over a step h deviates by at most K h^2 / 8 from the curve over the same w.
  const double k = std::ldexp(space_second_derivative(system, arc.tube), static_cast<int>(frame.exponent));
  const double wanted = std::ceil(arc.gate_w * std::sqrt(k / (8 * 0.9 * tolerance)));
  const int n = static_cast<int>(std::clamp(wanted, 1.0, 1e6));
  const double step = arc.gate_w / n;
  const double start = -0.5 * arc.gate_w;
  double vertex_error = 0;
  CuspPolyline result;
  for (int i = 0; i <= n; ++i) {
    const double tau = i == n ? 0.5 * arc.gate_w : start + arc.gate_w * (static_cast<double>(i) / n);
    const BoundedVertex v = vertex_at(system, i == 0 ? arc.cusp : point_at(arc.tube, tau), frame);
    result.vertices.push_back(v.vertex);
    vertex_error = std::max(vertex_error, v.error);
  }
  result.error_bound = (k * step * step / 8 * (1 + 0x1p-30) + 2 * vertex_error) * (1 + 0x1p-40);
  return result;
}

#define EXSECT_INSTANTIATE_CUSP_ARC(Ball)                                                                \
  template std::optional<CuspArc<Ball>> cusp_arc(const ChartSystem<Ball>&, const ChartCusp<Ball>&);      \
  template bool passes_through(const CuspArc<Ball>&, Chart, const BallPoint<Ball>&);                     \
  template Node cusp_node(const ChartSystem<Ball>&, const CuspArc<Ball>&, const ModelFrame&);            \
  template CuspPolyline cusp_polyline(const ChartSystem<Ball>&, const CuspArc<Ball>&, const ModelFrame&, \
                                      double);

EXSECT_INSTANTIATE_CUSP_ARC(DoubleBall)
EXSECT_INSTANTIATE_CUSP_ARC(ArbBall<256>)
#undef EXSECT_INSTANTIATE_CUSP_ARC

}  // namespace exsect
