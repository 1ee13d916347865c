// The boundary lines of two patches on one surface: points, arcs, and which arcs bound an overlap. Internal
// to solver/; docs/method.md, section 6.3.
#pragma once

#include <exsect/solver/result.h>

#include <vector>

#include "overlap/common_sheet.h"
#include "side/line_arcs.h"

namespace exsect {

/// rim: on one side of it, inside both squares, every pair of the common sheet is a solution. edge: on
/// neither side; the patches continue each other. branch: on no common sheet, the patches cross. unknown: it
/// lies on no common sheet, or that could not be proved.
enum class BoundaryArcKind { rim, edge, branch, unknown };

/// A maximal piece, free of other boundary points, of the solutions on a side of one square.
struct BoundaryArc {
  std::size_t from;  // indices of OverlapBoundary::points
  std::size_t to;
  CertifiedPoint inside;
  std::vector<PolylineVertex> polyline;
  double error_bound;
  BoundaryArcKind kind;
};

/// on_arc: an end of an arc. touch: the two parts of the common sheet have only this point in common near it.
/// other: anything else.
enum class BoundaryPointKind { on_arc, touch, other };

struct BoundaryPoint {
  CertifiedPoint at;
  BoundaryPointKind kind;
};

/// All solutions on the eight sides: the arcs, and the points that are no interior points of arcs, each once.
struct OverlapBoundary {
  std::vector<BoundaryPoint> points;
  std::vector<BoundaryArc> arcs;
  std::vector<Incomplete> incomplete;
};

OverlapBoundary overlap_boundary(const BezierPatch& x, const BezierPatch& y, const CommonSheets& sheets,
                                 const ModelScale& scale, double tolerance, const StopRequest& stop);

}  // namespace exsect
