// The graph of a surface given by its equation and a patch, from their curve in the patch's square. Internal
// to solver/; docs/method-equations.md, section 17.4.
#pragma once

#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/surface_curve.h>

#include <vector>

#include "answer/graph_builder.h"
#include "curve/curve_course.h"
#include "curve/drawn_patch.h"

namespace exsect {

/// The node of a place of the square, with r = s = 0, of no kind.
Node node_at(const NodePlace& place, const DrawnPatch& patch);
/// What is at the node of a curve, which has its sides, bounds and turning parameters.
std::vector<NodeKind> kinds_of(const CurveNode& at, const Node& node);
/// The vertices of a course, with r = s = 0.
std::vector<PolylineVertex> polyline_of(const CurveCourse& course);
/// Whether the arc lies on a side of the square; its nodes are `from` and `to`.
ArcPlace place_of_arc(const CurveBranch& arc, const Node& from, const Node& to);

/// Nodes and arcs are those of common.graph, in their order: folds, and where CurveNode::turns_in_v, are
/// turning points. Polylines keep within `tolerance` (a length). r and s are 0.
GraphBuilder surface_graph(const SurfaceCurve& common, const DrawnPatch& patch, double tolerance);

}  // namespace exsect
