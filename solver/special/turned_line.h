// Parameter lines along which a patch is singular, because its derivative across vanishes on all of the line.
// Internal to solver/; docs/method.md, section 6.7.
#pragma once

#include <exsect/solver/result.h>

#include <vector>

#include "answer/graph_builder.h"
#include "side/line_arcs.h"

namespace exsect {

/// The solutions on such a line, which is a side of one of the squares.
class TurnedLine {
 public:
  /// The polylines that are made on the way keep within `tolerance`, as in line_arcs.
  TurnedLine(const BezierPatch& x, const BezierPatch& y, Side side, const ModelScale& scale, double tolerance,
             const StopRequest& stop);

  /// Which arcs of the graph of x = y lie on the line; empty if that is not decided.
  std::optional<std::vector<bool>> arcs_along(const GraphBuilder& graph) const;
  /// The node's point, on the line but on none of its arcs, is known to be singular.
  bool is_singular(const Node& node) const;

 private:
  const BezierPatch& x_;
  const BezierPatch& y_;
  Side side_;
  std::size_t along_;
  LinePoints isolated_;
  LineArcs arcs_;
};

bool lies_on(const Node& node, const Side& side);

/// Marks in the graph of x = y that one patch is singular along the side: arcs on it are tangential, and its
/// points at which the curve is singular have a kind, apart from ends of tangential arcs. What is not decided
/// is appended to `undecided`.
void mark_turned_line(GraphBuilder& graph, std::vector<Incomplete>& undecided, const BezierPatch& x,
                      const BezierPatch& y, Side side, const ModelScale& scale, double tolerance,
                      const StopRequest& stop);

}  // namespace exsect
