#include "certificate/gates.h"

#include <algorithm>
#include <cmath>

namespace exsect::cli {
namespace {

const Map& chart_map(const NearPair& pair, Chart chart) {
  return pair.charts[chart == Chart::first ? 0 : 1].equation;
}

/// Takes off the points before the gate, `along` a chart's axis, and returns them; the gate becomes the
/// first one.
template <class Along, class Projected, class At>
std::vector<TracedPoint> cut(std::vector<TracedPoint>& points, double gate, const Along& along,
                             const Projected& projected, const At& at) {
  gate = std::min(gate, 0.4 * along(points.back().at));
  for (const TracedPoint& q : points)  // none too near
    if (std::abs(along(q.at) - gate) < 0.01 * gate) gate *= 0.97;
  std::vector<TracedPoint> result = {points[0]};
  std::size_t i = 1;
  for (; i + 1 < points.size() && along(points[i].at) < gate; ++i)
    result.push_back({projected(points[i].at), points[i].vertex});
  points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i));
  points.insert(points.begin(), {at(gate), -1});
  return result;
}

double distance_to_edge(const Parameters& w, const Parameters& a, const Parameters& b) {
  double along = 0;
  double length = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    along += (w[i] - a[i]) * (b[i] - a[i]);
    length += (b[i] - a[i]) * (b[i] - a[i]);
  }
  const double t = std::clamp(along / length, 0.0, 1.0);
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += std::pow(a[i] + t * (b[i] - a[i]) - w[i], 2);
  return sum;
}

}  // namespace

Tube cusp_tube(const NearPair& pair, Parameters& w) {
  const Map local = pair.power.at(w);
  const std::array columns = {local.slope(0), local.slope(1)};
  const std::array length = {checker::dot(columns[0], columns[0]), checker::dot(columns[1], columns[1])};
  const Chart chart = length[0] < length[1] ? Chart::first : Chart::second;
  const std::size_t p = chart == Chart::first ? 0 : 1;
  const double m = -checker::dot(columns[0], columns[1]) / length[1 - p];  // x_u + m x_v = 0
  const Parameters z = on_curve(chart_map(pair, chart), {w[p], w[1 - p], m, 0}, 3);
  if (!(std::abs(z[0] - w[p]) < 1e-6)) throw NoCertificate("a cuspidal point that is not found again");
  w[p] = w[p + 2] = z[0];
  w[1 - p] = w[3 - p] = z[1];
  return tube_at({chart_map(pair, chart), chart}, z, 3);
}

double cusp_radius(const NearPair& pair, const Tube& tube, const Parameters& w) {
  const std::size_t p = tube.chart == Chart::first ? 0 : 1;
  const Parameters z = {w[p], w[1 - p], tube.centre[2], 0};
  return std::exp2(
      std::ceil(std::log2(std::max(16 * distance(chart_map(pair, tube.chart), tube, z), 0x1p-40))));
}

std::vector<TracedPoint> leave_diagonal(const NearPair& pair, std::vector<TracedPoint>& points,
                                        const Tube& tube) {
  const std::size_t p = tube.chart == Chart::first ? 0 : 1;
  const Map& map = chart_map(pair, tube.chart);
  const int side = points[1].at[p] > points[1].at[p + 2] ? 1 : -1;
  return cut(
      points, 0.5 * tube.reach, [&](const Parameters& w) { return in_chart(tube.chart, w)[3]; },
      [&](const Parameters& w) {
        return pair_of(tube.chart, on_curve(map, in_chart(tube.chart, w), 3), side);
      },
      [&](double gate) {
        Parameters z = tube.centre;
        for (std::size_t j = 0; j < 4; ++j) z[j] += gate * tube.slope[j];
        return pair_of(tube.chart, on_curve(map, z, 3), side);
      });
}

std::vector<TracedPoint> leave_star(std::vector<TracedPoint>& points, const FoundStar& star,
                                    const Tube& tube) {
  constexpr double step = 1.0 / 32;
  const auto at = [&](double t) { return parameters_of(star, tube, on_half_branch(star, tube, t)); };
  const auto along = [&](const Parameters& w) { return distance_from_point(star.claim, w); };
  // Half branches may be nearer to each other than the polyline is to either: only t is taken from it.
  const std::vector<TracedPoint> few = cut(
      points, 0.9, along, [&](const Parameters& w) { return at(along(w)); }, at);
  std::vector<TracedPoint> result;
  for (std::size_t i = 0; i < few.size(); ++i) {
    const double begin = i == 0 ? 0 : along(few[i].at);
    const double length = along(i + 1 < few.size() ? few[i + 1].at : points[0].at) - begin;
    result.push_back(few[i]);
    const int steps = static_cast<int>(std::ceil(length / step));
    for (int n = 1; n < steps; ++n) result.push_back({at(begin + n * length / steps), -1});
  }
  return result;
}

double distance_to_half_branch(const FoundStar& star, const Tube& tube,
                               const std::vector<TracedPoint>& points) {
  const Parameters w = parameters_of(star, tube, on_half_branch(star, tube, 0.9));
  double least = 1e300;
  for (std::size_t j = 0; j + 1 < points.size(); ++j) {
    least = std::min(least, distance_to_edge(w, points[j].at, points[j + 1].at));
    if (distance_from_point(star.claim, points[j + 1].at) > 1) break;
  }
  return least;
}

}  // namespace exsect::cli
