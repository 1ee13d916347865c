// All pairs of parameters of one patch, in pairs of cells. Internal to solver/; docs/method-doubles.md,
// section 14.17.
#pragma once

#include <exsect/solver/result.h>

#include <optional>
#include <string>
#include <vector>

#include "answer/run.h"
#include "self/known_pinches.h"
#include "self/parameter_cells.h"
#include "self/patch_injectivity.h"
#include "self/pinch_proof.h"
#include "self/poles.h"

namespace exsect {

/// The pieces over two cells without a common point of parameters meet in this, in their own parameters:
/// complete, without overlaps.
struct SolvedCells {
  std::size_t first;
  std::size_t second;
  IntersectionGraph graph;
};

/// The pairs of one cell with itself, about a pinch point.
struct PinchCell {
  std::size_t cell;
  PinchProof proof;
  std::optional<KnownPinch> on;  // a side of the square, the only one that the cell reaches
  bool along = false;            // both points of all pairs are on this side
};

/// If there are no problems: every pair of different parameters with one point of space lies, in one of its
/// orders, in the cells of one of `solved`, or in a pinch cell twice, or on the side of one pole.
struct CellPairs {
  CellTree cells;
  std::vector<Pole> poles;
  std::vector<SolvedCells> solved;
  std::vector<PinchCell> pinches;
  std::vector<Incomplete> problems;
  long pairs = 0;  // looked at
};

/// `is_injective`: of the patch, not empty. `grid`: see CellTree. No cell of pairs that are solved, and no
/// pinch cell, has one of the `lines` inside. `extent`: of the model.
CellPairs cell_pairs(const RationalPatch& patch, const InjectiveRectangle& is_injective, unsigned grid,
                     const ParameterLines& lines, double extent, const Run& run);

/// Near the middle of the cell's box.
Point origin_of(const ParameterCell& cell);

}  // namespace exsect
