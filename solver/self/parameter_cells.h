// A parameter square in rectangles, with the pieces of the patch over them. Internal to solver/;
// docs/method-doubles.md, section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <optional>
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

/// Lines u = constant and v = constant of the square.
using ParameterLines = std::array<std::vector<Rational>, 2>;

/// The square, and cells cut in two when that is asked for: along one of the lines, if there are any inside
/// of the cell, else across the longer side, somewhere near its middle. Such cuts of different cells are in
/// different places, and in others for each `grid`. Indices stay valid, references do not.
class CellTree {
 public:
  CellTree(const RationalPatch& patch, unsigned grid, ParameterLines lines = {},
           std::vector<std::array<double, 2>> inside = {});
  const ParameterCell& operator[](std::size_t i) const { return cells_[i]; }
  std::size_t split(std::size_t i);
  bool has_line_inside(std::size_t i) const { return line_inside(i).has_value(); }

 private:
  /// Across the first (0) or second (1) side, at a place in (0,1) of it.
  struct Division {
    std::size_t side;
    Rational place;
  };
  std::optional<Division> line_inside(std::size_t cell) const;
  Rational cut_place(std::size_t cell, std::size_t side) const;

  std::vector<ParameterCell> cells_;
  ParameterLines lines_;
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
