// Points of a curve on a round chart between two places of it, two at once in plain doubles. Internal to
// solver/; docs/method-equations.md, section 17.21.
#pragma once

#include <array>

#include "filter/round_tube.h"
#include "trace/arc_polyline.h"

namespace exsect {

/// A place of the curve over the offset s, and what is known of the arc around it.
struct RoundNode {
  double s;
  NearCurve near;
  RoundArc arc;
};

/// A point of space in doubles, and its distance from the point of the curve it stands for.
BoundedVertex round_vertex(const RoundTube& tube, const NearCurve& near);

/// The curve between two nodes of a tube.
class RoundPart {
 public:
  /// Vertices have to be within `wanted` of the curve by the other coordinate.
  RoundPart(const RoundTube& tube, const RoundNode& a, const RoundNode& b, double wanted);

  /// Adds the vertices that divide the part into `count` equal steps.
  void add_vertices(int count, ArcPolyline& line) const;

 private:
  static constexpr std::size_t kLanes = 2;
  using Pair = std::array<double, kLanes>;
  struct Points {
    Pair off;
    Pair value;
    std::array<Pair, 3> at;
  };
  void evaluate(const Pair& x, Points& points) const;
  BoundedVertex vertex(double s, const Points& points, std::size_t i) const;

  const RoundTube& tube_;
  const NearCurve& from_;
  double s_, length_;
  double wanted_;
  double value_error_, position_error_;
  /// About the other coordinate, from that of `from_` on, by the part of the length: the polynomial of degree
  /// 5 with the values, slopes and bends of the nodes.
  std::array<double, 6> series_;
};

}  // namespace exsect
