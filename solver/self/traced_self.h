// What has been proved of a patch against itself, and its graph. Internal to solver/.
#pragma once

#include <functional>
#include <vector>

#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "answer/run.h"
#include "self/curves.h"

namespace exsect {

/// It refers to nothing else; exact.zero_tangent and exact.common_zero are empty.
template <class Ball>
struct TracedSelf {
  BezierPatch x;
  ModelScale scale;
  SelfSystem<Ball> system;
  ExactPlaces exact;
  SelfCurves<Ball> curves;
};

/// Nodes and arcs of the curves, within the tolerance of the run where doubles can express that: landmarks
/// are the first nodes, a star has one for each order of its centre. Turning points are nodes with respect to
/// in_both_orders of the run's parameters.
template <class Ball>
GraphBuilder drawn_curves(const TracedSelf<Ball>& self, const Run& run);

/// What is known of a patch that is not one of self_intersect_degenerate().
struct KnownSelf {
  BezierPatch x;
  /// drawn_curves() of what was traced; empty if there are no curves.
  std::function<GraphBuilder(const Run&)> curves;
  std::vector<std::array<int, 2>> collapsed_sides;  // fixed parameter and value
  std::vector<std::size_t> mates;                   // see join_orders()
  bool has_stars;                                   // their size is by the tolerance of the call
  std::vector<Incomplete> incomplete;
};

/// The curves, and the sides that are one point.
GraphBuilder drawn_pairs(const KnownSelf& known, const Run& run);

/// The result of the run.
IntersectResult drawn(const KnownSelf& known, const Run& run);

/// The result of this run, drawn again with it unless smaller stars may help with the tolerance.
IntersectResult kept(KnownSelf known, const Run& run);

}  // namespace exsect
