// The graph of a patch that lies on a surface, from what the surface's region leaves of the patch's square.
// Internal to solver/; docs/method-equations.md, section 17.13.
#pragma once

#include <exsect/solver/surface_curve.h>

#include "answer/graph_builder.h"
#include "curve/drawn_patch.h"
#include "curve/region_outline.h"

namespace exsect {

/// Nodes are those of outline.graph, in their order; arcs are outline.curves, isolated points outline.points;
/// and there is an overlap for each part, with its chains. Polylines keep within `tolerance` (a length). r
/// and s are 0. Requires common.contains_patch, and the outline of common.region.
GraphBuilder outline_graph(const SurfaceCurve& common, const RegionOutline& outline, const DrawnPatch& patch,
                           double tolerance);

}  // namespace exsect
