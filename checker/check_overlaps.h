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
        seam_(element(replay.certificate.seams, overlap_.seam, "names no seam")),
        frame_(seam_) {
    for (const Arc<N>& edge : overlap_.edges) corners_.push_back(edge.ends[0]);
  }

  /// The corners are those of the plane's part in [0,1]^4.
  void check() const {
    require(seam_.is_plane(), "its seam is not one of a plane");
    require(corners_.size() >= 3, "less than three corners");
    for (const auto& corner : corners_) {
      require(is_on(seam_, corner), "a corner is not on its seam's plane");
      for (const Rational& e : frame_.of(corner)) require(abs(e) <= 1, "a corner is beyond its seam");
      for (const Rational& q : corner) require(q >= 0 && q <= 1, "a corner is not in [0,1]^4");
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) check_edge(i);
    for (std::size_t i = 0; i < index_; ++i) {
      const auto& other = replay_.certificate.seams[replay_.certificate.overlaps[i].seam];
      const auto on_it = [&](const Vector4<Rational>& corner) { return is_on(other, corner); };
      require(!std::all_of(corners_.begin(), corners_.end(), on_it), "the same as an earlier one");
    }
  }

 private:
  /// The sign of (b - a) x (c - a) in the plane.
  int turn(const Vector4<Rational>& a, const Vector4<Rational>& b, const Vector4<Rational>& c) const {
    std::vector<std::array<Rational, 2>> difference;
    const Vector4<Rational> from = frame_.of(a);
    const Vector4<Rational> to = frame_.of(b);
    const Vector4<Rational> other = frame_.of(c);
    for (std::size_t j = 0; j < 4; ++j)
      if (seam_.weights[j] == 0) difference.push_back({to[j] - from[j], other[j] - from[j]});
    return sign(Rational(difference[0][0] * difference[1][1] - difference[0][1] * difference[1][0]));
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
    replayed(edges, i, [&] { check_polyline(overlap_.edges[i], a, b); });
  }

  void check_polyline(const Arc<N>& edge, const Vector4<Rational>& a, const Vector4<Rational>& b) const {
    Tube<N> tube = {};
    for (std::size_t p = 1; p < 4; ++p)
      if (abs(Rational(b[p] - a[p])) > abs(Rational(b[tube.axis] - a[tube.axis]))) tube.axis = {p};
    const std::size_t k = tube.axis;
    ProvedTube<N> line = {tube};
    line.exact.emplace();
    for (std::size_t p = 0; p < 4; ++p) {
      const Rational slope = (b[p] - a[p]) / (b[k] - a[k]);
      (*line.exact)[p] = {N(Rational(a[p] - slope * a[k])), N(slope), N(0)};
    }
    std::vector<Vector4<N>> at;
    std::vector<N> near;
    const int direction = b[k] > a[k] ? 1 : -1;
    for (const ArcPoint<N>& point : edge.points) {
      require(at.empty() || N(direction) * (point.at[k] - at.back()[k]) > 0, "an edge runs back");
      at.push_back(point.at);
      near.push_back(distance_to_line(*line.exact, k, point.at));
    }
    ErrorBound<N> bound(replay_, edge);
    bound.place_on_polyline();
    bound.check(line, 0, at, near);
  }

  const Replay<N>& replay_;
  const Overlap<N>& overlap_;
  std::size_t index_;
  const Star& seam_;
  const Frame<Rational> frame_;
  std::vector<Vector4<Rational>> corners_;
};

}  // namespace exsect::checker
