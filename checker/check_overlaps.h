// Overlaps: regions where both patches are one surface, with parameters that depend on each other linearly.
#pragma once

#include "check_arcs.h"

namespace exsect::checker {

/// The coordinates e of a place.
inline Vector4<Rational> coordinates(const Star& seam, const Vector4<Rational>& w) {
  Vector4<Rational> e = {};
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i) e[j] += seam.coordinates[j][i] * (w[i] - seam.at[i]);
  return e;
}

template <class N>
class OverlapCheck {
 public:
  OverlapCheck(const Replay<N>& replay, std::size_t i)
      : replay_(replay),
        overlap_(replay.certificate.overlaps[i]),
        index_(i),
        where_(place("overlaps", i)),
        seam_(element(replay.certificate.seams, overlap_.seam, where_, "names no seam")) {}

  /// The corners are those of the plane's part in [0,1]^4.
  void check() const {
    require(std::count(seam_.weights.begin(), seam_.weights.end(), std::size_t{0}) == 2, where_,
            "its seam is not one of a plane");
    require(overlap_.corners.size() >= 3, where_, "less than three corners");
    for (const auto& corner : overlap_.corners) {
      require(is_on(seam_, corner), where_, "a corner is not on its seam's plane");
      for (const Rational& e : coordinates(seam_, corner))
        require(abs(e) <= 1, where_, "a corner is beyond its seam");
      for (const Rational& q : corner) require(q >= 0 && q <= 1, where_, "a corner is not in [0,1]^4");
    }
    for (std::size_t i = 0; i < overlap_.corners.size(); ++i) check_edge(i);
    for (std::size_t i = 0; i < index_; ++i) {
      const auto& other = replay_.certificate.seams[replay_.certificate.overlaps[i].seam];
      const auto on_it = [&](const Vector4<Rational>& corner) { return is_on(other, corner); };
      require(!std::all_of(overlap_.corners.begin(), overlap_.corners.end(), on_it), where_,
              "the same as an earlier one");
    }
  }

 private:
  static bool is_on(const Star& seam, const Vector4<Rational>& w) {
    const Vector4<Rational> e = coordinates(seam, w);
    for (std::size_t j = 0; j < 4; ++j)
      if (seam.weights[j] > 0 && e[j] != 0) return false;
    return true;
  }

  /// The sign of (b - a) x (c - a) in the plane.
  int turn(const Vector4<Rational>& a, const Vector4<Rational>& b, const Vector4<Rational>& c) const {
    std::vector<std::array<Rational, 2>> difference;
    const Vector4<Rational> from = coordinates(seam_, a);
    const Vector4<Rational> to = coordinates(seam_, b);
    const Vector4<Rational> other = coordinates(seam_, c);
    for (std::size_t j = 0; j < 4; ++j)
      if (seam_.weights[j] == 0) difference.push_back({to[j] - from[j], other[j] - from[j]});
    return sign(Rational(difference[0][0] * difference[1][1] - difference[0][1] * difference[1][0]));
  }

  /// It is on a side of the squares, with all other corners on one side of it; the polyline is near it.
  void check_edge(std::size_t i) const {
    const auto& corners = overlap_.corners;
    const std::size_t next = (i + 1) % corners.size();
    const Vector4<Rational>& a = corners[i];
    const Vector4<Rational>& b = corners[next];
    const int orientation = turn(corners[0], corners[1], corners[2]);
    for (std::size_t j = 0; j < corners.size(); ++j)
      require(j == i || j == next || turn(a, b, corners[j]) * orientation > 0, where_,
              "not convex, or not in order");
    bool on_side = false;
    for (std::size_t p = 0; p < 4; ++p) {
      const bool along = a[p] == b[p] && (a[p] == 0 || a[p] == 1);
      on_side = on_side || (along && std::any_of(corners.begin(), corners.end(),
                                                 [&](const auto& c) { return c[p] != a[p]; }));
    }
    require(on_side, where_, "an edge is on no side");
    check_polyline(overlap_.edges[i], a, b, where_ + ".edges[" + std::to_string(i) + "]");
  }

  void check_polyline(const Arc<N>& edge, const Vector4<Rational>& a, const Vector4<Rational>& b,
                      const std::string& where) const {
    Tube<N> tube = {};
    for (std::size_t p = 1; p < 4; ++p)
      if (abs(Rational(b[p] - a[p])) > abs(Rational(b[tube.axis] - a[tube.axis]))) tube.axis = p;
    const std::size_t k = tube.axis;
    ProvedTube<N> line = {tube, {}, {}, {}, OnAxis<N>{}};
    for (std::size_t p = 0; p < 4; ++p) {
      const Rational slope = (b[p] - a[p]) / (b[k] - a[k]);
      (*line.exact)[p] = {N(Rational(a[p] - slope * a[k])), N(slope), N(0)};
    }
    std::vector<Vector4<N>> at;
    std::vector<N> near;
    const int direction = b[k] > a[k] ? 1 : -1;
    for (const ArcPoint<N>& point : edge.points) {
      require(at.empty() || N(direction) * (point.at[k] - at.back()[k]) > 0, where, "an edge runs back");
      at.push_back(point.at);
      near.push_back(distance_to_line(line, point.at));
    }
    ErrorBound<N> bound(replay_, edge);
    bound.place_on_polyline(where);
    bound.check(line, 0, at, near, where);
  }

  const Replay<N>& replay_;
  const Overlap<N>& overlap_;
  std::size_t index_;
  const std::string where_;
  const Star& seam_;
};

}  // namespace exsect::checker
