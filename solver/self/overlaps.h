// Overlaps of a patch with itself. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <vector>

#include "answer/graph_builder.h"
#include "answer/run.h"
#include "shape/self_symmetry.h"

namespace exsect {

struct SymmetricOverlaps {
  GraphBuilder graph;  // overlaps and their nodes
  std::vector<Incomplete> incomplete;
};

/// For each symmetry the region of pairs w, sigma(w), with its corners as nodes: of kind `cusp` where the two
/// points agree. Incomplete where a polyline cannot keep within the tolerance.
SymmetricOverlaps symmetric_overlaps(const BezierPatch& x, const std::vector<Symmetry>& symmetries,
                                     const Run& run);

}  // namespace exsect
