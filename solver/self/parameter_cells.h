// A parameter square in rectangles, with the pieces of the patch over them. Internal to solver/;
// docs/method-doubles.md, section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

#include "filter/mean_derivatives.h"
#include "shape/injective_rectangle.h"

namespace exsect {

/// The box of a piece, rounded outwards; all of space where weights are not positive.
struct PieceBox {
  std::array<double, 3> lower;
  std::array<double, 3> upper;
};
PieceBox box_of(const RationalPatch& piece);

/// A closed rectangle of positive width.
struct ParameterCell {
  ParameterRectangle where;
  RationalPatch piece;        // over it
  filter::Rectangle centred;  // of the parameters minus 1/2: contains it
  PieceBox box;
  int level;
  std::size_t children;  // index of the first of two; 0: not yet made
};

/// The square, and cells cut in two when that is asked for, across the longer side, somewhere near its
/// middle: cuts of different cells are in different places, and in others for each `grid`. Indices stay
/// valid, references do not.
class CellTree {
 public:
  CellTree(const RationalPatch& patch, unsigned grid, std::vector<std::array<double, 2>> inside = {});
  const ParameterCell& operator[](std::size_t i) const { return cells_[i]; }
  std::size_t split(std::size_t i);

 private:
  /// Where a cell is cut across its first (0), second (1) side, in (0,1).
  Rational cut_place(std::size_t cell, std::size_t side) const;

  std::vector<ParameterCell> cells_;
  unsigned grid_;
  std::vector<std::array<double, 2>> inside_;
};

/// The closed rectangles have a point in common.
bool touch(const ParameterCell& a, const ParameterCell& b);
/// The boxes have no point in common.
bool are_apart(const PieceBox& a, const PieceBox& b);
/// The smallest rectangle around both.
filter::Rectangle hull(const ParameterCell& a, const ParameterCell& b);

}  // namespace exsect
