// The arcs in which a parameter line of one patch lies on the other one: exact ends, certified polylines.
// Internal to solver/.
#pragma once

#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/line_query.h>

#include <optional>
#include <string>
#include <vector>

#include "answer/model_scale.h"
#include "trace/tracer.h"

namespace exsect {

/// A regular arc of solutions on a parameter line: the line's parameter t increases from `from` to `to`, and
/// nothing but the two ends is at an end of [0,1] in t, or on a side of the other patch unless the whole arc
/// is. `inside` is a point of the arc with rational t.
struct LineArc {
  std::size_t from;  // indices of LineArcs::ends
  std::size_t to;
  CertifiedPoint inside;
  std::vector<PolylineVertex> polyline;
  double error_bound;
  std::vector<ParameterBox> hulls;  // the arc is in their union
  bool collapsed = false;           // the line is one point, and r and s are constant
};

/// A parameter line `fixed = value` of the other patch that is mapped to one point of the line.
struct CollapsedLine {
  RealAlgebraic t;
  Parameter fixed;
  RealAlgebraic value;
};

/// All solutions on the line that are not isolated (LinePoints::on_patch), as long as `incomplete` is empty.
struct LineArcs {
  std::vector<CertifiedPoint> ends;  // distinct, boxes disjoint; possibly some where no arc ends
  std::vector<LineArc> arcs;
  std::vector<CollapsedLine> collapsed;
  std::optional<std::string> incomplete;
};

/// The polylines keep within `tolerance` (space units) where doubles can express that. If `thorough`, an arc
/// that cannot be traced in doubles is tried in 256 bits.
LineArcs line_arcs(const BezierPatch& x, const BezierPatch& y, const LineQuery& query,
                   const ModelScale& scale, double tolerance, const StopRequest& stop, bool thorough = true);

}  // namespace exsect
