// How many arcs end in a regular point of the intersection. Internal to solver/; docs/method.md, section 8.1.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/intersection_graph.h>

#include <optional>

#include "trace/pair_system.h"

namespace exsect {

/// The tangent (5.1) vanishes nowhere in the box around the node's point: there the solutions of x = y are
/// one smooth curve. Two arcs of it end in an inner point. At a side that the curve crosses it enters the
/// square in one direction (8.1): where all sides are crossed, one arc ends in the point if these directions
/// agree, and none if they do not.
class RegularDegree {
 public:
  RegularDegree(const BezierPatch& x, const BezierPatch& y);

  /// Empty if the tangent may vanish, or be along a side, or the node has free parameters.
  std::optional<int> operator()(const Node& node) const;

 private:
  PairSystem<DoubleBall> system_;
};

}  // namespace exsect
