// All solutions on the eight sides of the two parameter squares. Internal to solver/.
#pragma once

#include <exsect/solver/result.h>

#include <vector>

#include "side/common_pole.h"
#include "side/line_arcs.h"

namespace exsect {

/// A maximal piece, free of other boundary points, of the solutions on a side of one square that are not
/// isolated there.
struct SideArc {
  Side side;         // on which it was found
  std::size_t from;  // indices of BoundaryLines::points
  std::size_t to;
  CertifiedPoint inside;
  std::vector<PolylineVertex> polyline;
  double error_bound;
  std::vector<ParameterBox> hulls;  // the arc is in their union
  bool collapsed;                   // the side is one point of space
};

/// The arcs, and the points that are no interior points of arcs, each once; `incomplete` says what is
/// missing. All pairs on the poles are solutions; of these `points` has the corners and the ends of arcs.
struct BoundaryLines {
  std::vector<CertifiedPoint> points;
  std::vector<SideArc> arcs;
  std::vector<CommonPole> poles;
  std::vector<Incomplete> incomplete;
};

/// The polylines keep within `tolerance` (space units) where doubles can express that.
BoundaryLines boundary_lines(const BezierPatch& x, const BezierPatch& y, const ModelScale& scale,
                             double tolerance, const StopRequest& stop);

}  // namespace exsect
