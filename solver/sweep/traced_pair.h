// What the sweep has proved of a pair, and its graph. Internal to solver/.
#pragma once

#include <optional>
#include <vector>

#include "answer/model_scale.h"
#include "answer/run.h"
#include "side/boundary_lines.h"
#include "sweep/sweep_data.h"
#include "sweep/traced_curves.h"

namespace exsect {

/// The points and arcs on sides, the stars and the traced curves are the whole
/// intersection, but for what `incomplete` and traced.problems say. It refers
/// to nothing else.
template <class Ball>
struct TracedPair {
  BezierPatch x;
  BezierPatch y;
  ModelScale scale;
  double tolerance;  // a length, for which the arcs on sides are drawn and the
                     // stars are small enough
  BoundaryLines sides;
  std::vector<LandmarkPoint> points;  // landmark i encloses point i
  std::vector<StarNeighbourhood> stars;
  std::vector<Incomplete> incomplete;
  PairSystem<Ball> system;
  Landmarks<Ball> landmarks;
  TracedCurves<Ball> traced;
};

/// Of the arcs on sides, by the tolerance of all.
double side_tolerance(double tolerance);

/// The result with polylines within the tolerance of the run, or as near to the
/// curve as doubles can write them. Empty where more precision than that of
/// DoubleBall, or smaller stars, may help with that.
template <class Ball>
std::optional<IntersectResult> drawn(const TracedPair<Ball>& pair, const Run& run);

}  // namespace exsect
