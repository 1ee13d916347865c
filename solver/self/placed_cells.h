// What a pair of cells meets in, in the parameters of the whole patch. Internal to solver/;
// docs/method-doubles.md, section 14.17.
#pragma once

#include <vector>

#include "self/cell_pairs.h"

namespace exsect {

/// A side of a cell that is none of the square's: parameter = value; the cell lies below it if `upper`.
struct Cut {
  std::size_t parameter;  // 0..3
  Rational value;
  bool upper;
};

/// A node, and what it would be without cuts: `on` names sides of the square only.
struct PlacedNode {
  Node node;
  std::vector<Cut> cuts;  // it lies on
  int arcs = 0;           // that end in it
};

struct PlacedCells {
  std::vector<PlacedNode> nodes;  // as in the graph
  std::vector<Arc> arcs;
  std::vector<int> isolated;
  bool along_cut = false;  // an arc lies on a cut
};
PlacedCells placed_cells(const CellTree& cells, const SolvedCells& solved);

}  // namespace exsect
