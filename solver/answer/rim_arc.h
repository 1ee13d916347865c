// Arcs of a rim along straight lines of both parameter squares. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/intersection_graph.h>

#include <array>

namespace exsect {

/// A pair of parameters (u1,v1,u2,v2) of one patch, exactly, and its node.
struct RimEnd {
  std::array<Rational, 4> at;
  int node;
};

/// The node of a pair, or of parameters (u,v,r,s) of two patches, on a side of a square: all but its id and
/// its point of space.
Node rim_node(const std::array<Rational, 4>& at);

/// All pairs on the segment between two pairs as an arc of contact `tangential`. Both points of each pair
/// must be mapped to the same point of space. The polyline keeps within `tolerance` (space units) where
/// doubles can express that; Arc::error_bound is what is proved. Id 0.
Arc rim_arc(const BezierPatch& x, const RimEnd& from, const RimEnd& to, ArcPlace place, double tolerance);
/// The same of a patch of any bidegree, with weights or without, that is not biquadratic, for segments on
/// which one of its parameters is constant. The bound is infinite where parts of the line have control
/// points that are not points of space.
Arc rim_arc(const RationalPatch& x, const RimEnd& from, const RimEnd& to, ArcPlace place, double tolerance);

}  // namespace exsect
