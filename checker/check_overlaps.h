// Overlaps: regions where both patches are one surface, with parameters that depend on each other linearly.
#pragma once

#include "check_arcs.h"

namespace exsect::checker {

template <class N>
class OverlapCheck {
 public:
  OverlapCheck(const Replay<N>& replay, std::size_t i)
      : replay_(replay),
        overlap_(replay.certificate.overlaps[i]),
        index_(i),
        factor_(element(replay.certificate.factors, overlap_.factor, "names no factor")) {
    for (const Arc<N>& edge : overlap_.edges) corners_.push_back(edge.ends[0]);
  }

  /// The corners are those of the plane's part in [0,1]^4.
  void check() {
    require(is_plane(), "its factor is not one of a plane");
    require(corners_.size() >= 3, "less than three corners");
    for (const auto& corner : corners_) {
      require(is_on(factor_, corner), "a corner is not on its plane");
      for (const Rational& q : corner) require(q >= 0 && q <= 1, "a corner is not in [0,1]^4");
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) check_edge(i);
    for (std::size_t i = 0; i < index_; ++i) {
      const Factor& other = replay_.certificate.factors[replay_.certificate.overlaps[i].factor];
      const auto on_it = [&](const Vector4<Rational>& corner) { return is_on(other, corner); };
      require(!std::all_of(corners_.begin(), corners_.end(), on_it), "the same as an earlier one");
    }
  }

 private:
  static bool is_on(const Factor& factor, const Vector4<Rational>& w) {
    const Vector3<Rational> g = factor.map.value(w);
    return g[0] == 0 && g[1] == 0;
  }
  /// g_1 and g_2 are linear, and their derivatives with respect to two parameters independent: the two others
  /// are coordinates of the plane.
  bool is_plane() {
    const auto linear = [](const auto& term) {
      return (term.c[0] == 0 && term.c[1] == 0) ||
             std::accumulate(term.power.begin(), term.power.end(), 0) <= 1;
    };
    const auto& terms = factor_.map.terms();
    if (!factor_.is_surface() || !std::all_of(terms.begin(), terms.end(), linear)) return false;
    const auto slope = [&](std::size_t d, std::size_t i) { return Rational(factor_.map.slope(i)[d]); };
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        if (slope(0, i) * slope(1, j) == slope(0, j) * slope(1, i)) continue;
        auto coordinate = coordinates_.begin();
        for (std::size_t k = 0; k < 4; ++k)
          if (k != i && k != j) *coordinate++ = k;
        return true;
      }
    }
    return false;
  }
  /// The sign of (b - a) x (c - a) in the plane.
  int turn(const Vector4<Rational>& a, const Vector4<Rational>& b, const Vector4<Rational>& c) const {
    const auto [i, j] = coordinates_;
    return sign(Rational((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i])));
  }

  /// It is on a side of the squares, with all other corners on one side of it; the polyline is near it.
  void check_edge(std::size_t i) const {
    const std::size_t next = (i + 1) % corners_.size();
    const Vector4<Rational>& a = corners_[i];
    const Vector4<Rational>& b = corners_[next];
    const std::string edges = place("$.overlaps", index_) + ".edges";
    replayed(edges, i,
             [&] { require(overlap_.edges[i].ends[1] == b, "does not end where the next one begins"); });
    const int orientation = turn(corners_[0], corners_[1], corners_[2]);
    bool on_side = false;
    for (std::size_t j = 0; j < corners_.size(); ++j) {
      require(j == i || j == next || turn(a, b, corners_[j]) * orientation > 0,
              "not convex, or not in order");
      for (std::size_t p = 0; p < 4; ++p)
        on_side = on_side || (a[p] == b[p] && (a[p] == 0 || a[p] == 1) && corners_[j][p] != a[p]);
    }
    require(on_side, "an edge is on no side");
    replayed(edges, i, [&] { check_polyline(i, a, b); });
  }

  /// With the straight line from a to b as the curve of a tube.
  void check_polyline(std::size_t i, const Vector4<Rational>& a, const Vector4<Rational>& b) const {
    const Arc<N>& edge = overlap_.edges[i];
    Tube<N> tube = {};
    for (std::size_t p = 1; p < 4; ++p)
      if (abs(Rational(b[p] - a[p])) > abs(Rational(b[tube.axis] - a[tube.axis]))) tube.axis = {p};
    const std::size_t k = tube.axis;
    tube.reach = tube.width = N(2);
    Map<Rational> map;
    for (std::size_t d = 0; d < 3; ++d) {
      const std::size_t p = others(k)[d];
      const Rational slope = (b[p] - a[p]) / (b[k] - a[k]);
      Vector3<Rational> unit = {};
      unit[d] = 1;
      tube.inverse[d][d] = N(1);
      Power power = {};
      map.add(power, unit, slope * a[k] - a[p]);
      power[p] = 1;
      map.add(power, unit, 1);
      power[p] = 0;
      power[k] = 1;
      map.add(power, unit, -slope);
    }
    const ProvedTube<N> line = {tube, rounded<N>(map)};
    std::vector<Vector4<N>> at;
    std::vector<N> near;
    const int direction = b[k] > a[k] ? 1 : -1;
    for (const ArcPoint<N>& point : edge.points) {
      require(at.empty() || N(direction) * (point.at[k] - at.back()[k]) > 0, "an edge runs back");
      at.push_back(point.at);
      near.push_back(distance(line, point.at));
    }
    ErrorBound<N> bound(replay_, edge);
    bound.place_on_polyline();
    bound.add(line, 0, at, near);
    replay_.check_error_bound(index_, i, [&] { bound.check(); });
  }

  const Replay<N>& replay_;
  const Overlap<N>& overlap_;
  std::size_t index_;
  const Factor& factor_;
  std::array<std::size_t, 2> coordinates_ = {};
  std::vector<Vector4<Rational>> corners_;
};

}  // namespace exsect::checker
