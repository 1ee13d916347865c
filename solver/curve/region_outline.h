// A region of the unit square by its rim, exact. Internal to solver/; docs/method-equations.md,
// section 17.13.
#pragma once

#include <exsect/solver/curve_graph.h>

#include <vector>

namespace exsect {

/// An arc of the rim, run through with the region to the left of it, u to the right and v upwards.
struct OutlineArc {
  std::size_t arc;  // in RegionOutline::graph
  bool is_reversed;
};

/// A connected part with inner points: closed chains of arcs, each of which begins where the one before it
/// ends.
struct RegionPart {
  std::vector<std::vector<OutlineArc>> chains;
};

/// Invariant: the points of [0,1]^2 in the region are those of the parts, of the arcs `curves`, ends
/// included, and the nodes `points`; the latter two lie in no part, but for the ends of curves.
struct RegionOutline {
  CurveGraph graph;  // zeros of all bounds, and the sides of the square
  std::vector<RegionPart> parts;
  std::vector<std::size_t> curves;
  std::vector<std::size_t> points;
};

RegionOutline outline(const CurveRegion& region);

}  // namespace exsect
