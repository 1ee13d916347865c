#include "filter/newton_polygon.h"

#include <numeric>
#include <optional>

namespace exsect::filter {

namespace {

/// The least j with a term p^i q^j.
std::optional<int> lowest_in(const PlaneSeries& series, int i) {
  for (int j = 0; i + j <= series.order(); ++j)
    if (series.coefficient(i, j) != 0) return j;
  return std::nullopt;
}

PolygonEdge edge_between(const PlaneSeries& series, const std::array<int, 2>& from,
                         const std::array<int, 2>& to) {
  const int across = to[0] - from[0], down = from[1] - to[1];
  const int common = std::gcd(across, down);
  PolygonEdge edge{down / common, across / common, 0, to, from, {}};
  edge.degree = edge.p_weight * from[0] + edge.q_weight * from[1];
  std::vector<Rational> coefficients(static_cast<std::size_t>(from[1]) + 1);
  for (int k = 0; k <= common; ++k) {
    const int i = from[0] + k * edge.q_weight, j = from[1] - k * edge.p_weight;
    if (i + j <= series.order()) coefficients[static_cast<std::size_t>(j)] = series.coefficient(i, j);
  }
  edge.in_c = Polynomial(coefficients);
  return edge;
}

}  // namespace

std::vector<PolygonEdge> newton_polygon(const PlaneSeries& series) {
  std::vector<std::array<int, 2>> hull;
  for (int i = 0; i <= series.order(); ++i) {
    const auto j = lowest_in(series, i);
    if (!j) continue;
    if (!hull.empty() && *j >= hull.back()[1]) continue;
    const auto is_above = [&](const std::array<int, 2>& a, const std::array<int, 2>& b) {
      return (b[0] - a[0]) * (*j - a[1]) <= (b[1] - a[1]) * (i - a[0]);
    };
    while (hull.size() > 1 && is_above(hull[hull.size() - 2], hull.back())) hull.pop_back();
    hull.push_back({i, *j});
  }
  if (hull.size() < 2 || hull.front()[0] != 0 || hull.back()[1] != 0) return {};
  std::vector<PolygonEdge> edges;
  for (std::size_t k = 0; k + 1 < hull.size(); ++k)
    edges.push_back(edge_between(series, hull[k], hull[k + 1]));
  return edges;
}

}  // namespace exsect::filter
