// The self-intersection of a patch with nodes at given pairs. Internal to solver/; docs/method.md,
// section 6.3.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>
#include <vector>

#include "answer/graph_builder.h"
#include "answer/run.h"
#include "self/cuts.h"

namespace exsect {

/// The graph of self_intersect() with a node at every cut, before it is finished. Every arc is
/// strictly monotone or constant in each of the four parameters.
struct CutSelfIntersection {
  struct NodeOfCut {
    int node;
    bool exchanged;  // the pair of the node is the cut's in the other order
  };

  GraphBuilder graph;
  std::vector<std::vector<NodeOfCut>> cuts;
};

/// Empty if the result is incomplete, if a cut cannot be found in it, or if the patch is one of
/// self_intersect_degenerate() or has a side that is one point.
std::optional<CutSelfIntersection> cut_self_intersection(const BezierPatch& x, const Run& run,
                                                         const std::vector<PairCut>& cuts);

}  // namespace exsect
