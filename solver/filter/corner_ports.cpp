#include "filter/corner_ports.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "filter/port_point.h"
#include "filter/tube_newton.h"

namespace exsect::filter {

namespace {

/// Ports are looked for up to so many powers of two inside of the box of the corner, nearest first.
constexpr long kDeepestPort = 12;
constexpr std::array<int, 4> kChartWidths = {4, 6, 8, 11};
/// Of half of the chart.
constexpr double kShareOfChart = 0.9;

double rounded_value(const PlaneSeries& f, double p, double q) {
  double sum = 0;
  for (int i = 0; i <= f.order(); ++i)
    for (int j = 0; i + j <= f.order(); ++j)
      sum += to_double(f.coefficient(i, j)) * std::pow(p, i) * std::pow(q, j);
  return sum;
}

template <class K>
class BranchPort {
 public:
  BranchPort(const PairOf<K>& pair, const Vec4& corner, const ControlVectors& x, const CornerBranches& found,
             const CornerBranch& branch)
      : pair_(pair), corner_(corner), x_(x), found_(found), branch_(branch) {}

  std::optional<PortOf<K>> port() const {
    for (long k = found_.k + kDeepestPort; k > found_.k; --k)
      for (const int width : kChartWidths) {
        const Rational middle = branch_.c.midpoint(), half = middle * power_of_two(-width);
        const CornerChart chart{branch_.edge, {middle - half, middle + half}, k};
        if (chart.c.lower < branch_.c.lower || chart.c.upper > branch_.c.upper) continue;
        if (!is_one_branch(found_.equation.normal, chart) || !all_increase(found_.equation, chart)) continue;
        if (auto port = port_in(chart)) return port;
        break;
      }
    return std::nullopt;
  }

 private:
  /// Approximately, counted from the corner.
  Vec4 values(double c, double t) const {
    const CornerEquation& equation = found_.equation;
    const double p = std::pow(t, branch_.edge.p_weight), q = c * std::pow(t, branch_.edge.q_weight);
    Vec4 result{};
    result[equation.split.free[0]] = p;
    result[equation.split.free[1]] = q;
    for (std::size_t i = 0; i < 2; ++i)
      result[equation.split.bound[i]] = rounded_value(equation.bound[i], p, q);
    return result;
  }

  std::optional<PortOf<K>> port_in(const CornerChart& chart) const {
    const double c = to_double(chart.c.midpoint());
    const double size = std::ldexp(1.0, -static_cast<int>(chart.k));
    const double t = 0.5 * kShareOfChart *
                     std::min(std::pow(size, 1.0 / chart.edge.p_weight),
                              std::pow(size / to_double(chart.c.upper), 1.0 / chart.edge.q_weight));
    const Vec4 at = values(c, t), next = values(c, 1.01 * t);
    Vec4 place{}, rate{};
    for (std::size_t j = 0; j < 4; ++j) {
      place[j] = corner_[j] > 0 ? 0.5 - at[j] : at[j] - 0.5;
      rate[j] = next[j] - at[j];
    }
    const std::size_t axis = steepest(rate);
    const auto ball = point_of_curve(pair_, place, axis);
    if (!ball || !has_room<K>(*ball)) return std::nullopt;
    const auto local = local_box(*ball);
    if (!is_on(chart, local)) return std::nullopt;
    PortOf<K> port{*ball, axis, corner_[axis], {}, chord(local), 0};
    port.vertex_error = larger_bound(vertex_error(pair_, corner_, 0),
                                     vertex_error(pair_, parameters_of(*ball), ball->radius));
    const bool is_bounded = port.vertex_error < HUGE_VAL && port.chord < HUGE_VAL;
    return is_bounded ? std::optional(std::move(port)) : std::nullopt;
  }

  /// Exactly, counted from the corner.
  std::array<RationalInterval, 4> local_box(const BallOf<K>& ball) const {
    const Rational radius = from_double(ball.radius), half(1, 2);
    std::array<RationalInterval, 4> local;
    for (std::size_t j = 0; j < 4; ++j) {
      const Rational middle = from_double(ball.middle[j]);
      const Rational at = corner_[j] > 0 ? Rational(half - middle) : Rational(half + middle);
      local[j] = {at - radius, at + radius};
    }
    return local;
  }

  /// (14.127): all solutions in the box are on the branch, half as far in t as the chart goes at most.
  bool is_on(const CornerChart& chart, const std::array<RationalInterval, 4>& local) const {
    const auto is_inside = [&](const RationalInterval& w) { return w.lower > 0 && w.upper <= found_.reach; };
    if (!std::ranges::all_of(local, is_inside)) return false;
    const RationalInterval& p = local[found_.equation.split.free[0]];
    const RationalInterval& q = local[found_.equation.split.free[1]];
    const int of_p = chart.edge.p_weight, of_q = chart.edge.q_weight;
    return power(q.lower, of_p) >= power(chart.c.lower, of_p) * power(p.upper, of_q) &&
           power(q.upper, of_p) <= power(chart.c.upper, of_p) * power(p.lower, of_q) &&
           p.upper <= power_of_two(-chart.k - of_p) && q.upper <= power_of_two(-chart.k - of_q);
  }

  /// Twice how far x is from the corner in the rectangle up to the port, which contains the arc; in scaled
  /// space.
  double chord(const std::array<RationalInterval, 4>& local) const {
    Rational far = 0, weight = x_[0][0][3];
    for (std::size_t i = 0; i < x_.size(); ++i)
      for (std::size_t j = 0; j < x_[i].size(); ++j) {
        if (i + j == 0) continue;
        const HomogeneousPoint& h = x_[i][j];
        const Rational size =
            power(local[0].upper, static_cast<int>(i)) * power(local[1].upper, static_cast<int>(j));
        far += (abs(h[0]) + abs(h[1]) + abs(h[2])) * size;
        weight -= abs(h[3]) * size;
      }
    if (!(weight > 0)) return HUGE_VAL;
    return kSlack *
           std::ldexp(to_double(Rational(2 * far / weight)), -static_cast<int>(pair_.frame.exponent));
  }

  const PairOf<K>& pair_;
  const Vec4& corner_;
  const ControlVectors& x_;
  const CornerBranches& found_;
  const CornerBranch& branch_;
};

}  // namespace

template <class K>
std::optional<CentreOf<K>> branched_corner(const PairOf<K>& pair, const CornerContact& corner,
                                           const CornerNet& x, const CornerBranches& found) {
  const Vec4 at = place_of<K>(corner);
  CentreOf<K> centre{{}, at, at, {}};
  for (std::size_t j = 0; j < 4; ++j) {
    const int value = at[j] > 0 ? 1 : 0;
    centre.box[j] = {value, value};
  }
  const ControlVectors powers = power_coefficients(x);
  for (const CornerBranch& branch : found.branches) {
    auto port = BranchPort<K>(pair, at, powers, found, branch).port();
    if (!port) return std::nullopt;
    centre.ports.push_back(*std::move(port));
  }
  return centre;
}

#define EXSECT_INSTANTIATE(K)                                                                    \
  template std::optional<CentreOf<K>> branched_corner<K>(const PairOf<K>&, const CornerContact&, \
                                                         const CornerNet&, const CornerBranches&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
