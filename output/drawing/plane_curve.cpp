#include "output/drawing/plane_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace exsect::cli {
namespace {

double distance_to_chord(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2 : 0;
  const double s = std::clamp(t, 0.0, 1.0);
  return std::hypot(p[0] - a[0] - s * dx, p[1] - a[1] - s * dy);
}

/// Values of f at the grid's vertices and its zeros on the grid's edges.
class Grid {
 public:
  Grid(const std::function<double(PlanePoint)>& f, int n) : f_(f), n_(n) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) positive_.push_back(f(vertex(i, j)) >= 0);
    }
  }

  PlanePoint vertex(int i, int j) const { return {double(i) / n_, double(j) / n_}; }
  bool positive(int i, int j) const { return positive_[static_cast<std::size_t>(j * (n_ + 1) + i)]; }

  /// Zero of f between a, where it is not negative, and b, where it is.
  PlanePoint zero_between(PlanePoint a, PlanePoint b) const {
    for (int step = 0; step < 20; ++step) {
      const PlanePoint middle = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
      (f_(middle) >= 0 ? a : b) = middle;
    }
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
  }

 private:
  const std::function<double(PlanePoint)>& f_;
  int n_;
  std::vector<bool> positive_;
};

/// Edges of the grid: the horizontal one to the right of vertex (i,j), or the vertical one above it.
struct Edge {
  int i;
  int j;
  bool vertical;
  auto operator<=>(const Edge&) const = default;
};

/// For each edge with a zero, the edges joined to it inside its one or two cells.
using Links = std::map<Edge, std::vector<Edge>>;

void link_cell(const Grid& grid, const std::function<double(PlanePoint)>& f, int n, int i, int j,
               Links& links) {
  // Corners and edges counterclockwise; edge k runs from corner k to corner k+1.
  const std::array<bool, 4> corner = {grid.positive(i, j), grid.positive(i + 1, j),
                                      grid.positive(i + 1, j + 1), grid.positive(i, j + 1)};
  const std::array<Edge, 4> edge = {Edge{i, j, false}, Edge{i + 1, j, true}, Edge{i, j + 1, false},
                                    Edge{i, j, true}};
  std::vector<std::size_t> crossed;
  for (std::size_t k = 0; k < 4; ++k) {
    if (corner[k] != corner[(k + 1) % 4]) crossed.push_back(k);
  }
  if (crossed.empty()) return;
  const auto join = [&](std::size_t a, std::size_t b) {
    links[edge[a]].push_back(edge[b]);
    links[edge[b]].push_back(edge[a]);
  };
  if (crossed.size() == 2) {
    join(crossed[0], crossed[1]);
    return;
  }
  const bool middle = f({(i + 0.5) / n, (j + 0.5) / n}) >= 0;
  const bool cut_off_first = middle != corner[0];  // the curve separates corner 0 from the middle
  join(cut_off_first ? 3 : 0, cut_off_first ? 0 : 1);
  join(cut_off_first ? 1 : 2, cut_off_first ? 2 : 3);
}

/// Removes the link between a and b.
void unlink(Links& links, const Edge& a, const Edge& b) {
  std::erase(links[a], b);
  std::erase(links[b], a);
}

/// Follows the links from `start`, removing them.
std::vector<Edge> take_chain(Links& links, const Edge& start) {
  std::vector<Edge> chain = {start};
  while (!links[chain.back()].empty()) {
    const Edge next = links[chain.back()].front();
    unlink(links, chain.back(), next);
    chain.push_back(next);
  }
  return chain;
}

}  // namespace

PlanePolyline simplified(const PlanePolyline& polyline, double tolerance) {
  if (polyline.size() < 3) return polyline;
  std::vector<bool> kept(polyline.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans = {{0, polyline.size() - 1}};
  while (!spans.empty()) {
    const auto [first, last] = spans.back();
    spans.pop_back();
    double worst = tolerance;
    std::size_t furthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distance_to_chord(polyline[i], polyline[first], polyline[last]);
      if (distance > worst) {
        worst = distance;
        furthest = i;
      }
    }
    if (furthest == first) continue;
    kept[furthest] = true;
    spans.push_back({first, furthest});
    spans.push_back({furthest, last});
  }
  PlanePolyline result;
  for (std::size_t i = 0; i < polyline.size(); ++i) {
    if (kept[i]) result.push_back(polyline[i]);
  }
  return result;
}

std::vector<PlanePolyline> zero_set(const std::function<double(PlanePoint)>& f, int n) {
  const Grid grid(f, n);
  Links links;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) link_cell(grid, f, n, i, j, links);
  }
  std::vector<Edge> starts;  // ends of open curves first, then any edge of a loop
  for (const auto& [edge, next] : links) {
    if (next.size() == 1) starts.push_back(edge);
  }
  for (const auto& [edge, next] : links) starts.push_back(edge);
  std::vector<PlanePolyline> curves;
  for (const Edge& start : starts) {
    if (links[start].empty()) continue;
    PlanePolyline curve;
    for (const Edge& edge : take_chain(links, start)) {
      const int i = edge.vertical ? edge.i : edge.i + 1;
      const int j = edge.vertical ? edge.j + 1 : edge.j;
      const bool forward = grid.positive(edge.i, edge.j);
      const PlanePoint near = grid.vertex(edge.i, edge.j);
      const PlanePoint far = grid.vertex(i, j);
      curve.push_back(forward ? grid.zero_between(near, far) : grid.zero_between(far, near));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace exsect::cli
