// Sides of the square that are one point of the patch, and pairs of rectangles of parameters that reach
// them. Internal to solver/; docs/method-doubles.md, section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/intersection_graph.h>

#include <vector>

#include "shape/injective_rectangle.h"

namespace exsect {

/// The side where the parameter `fixed`, 0 or 1 for u or v, has the value 0 or 1 is the point.
struct Pole {
  std::size_t fixed;
  int value;
  Point point;
};
std::vector<Pole> poles_of(const RationalPatch& patch);

/// The rectangle has a part of the side.
bool reaches(const ParameterRectangle& where, const Pole& pole);

/// True only if the pieces of the patch over two rectangles that reach the pole have nothing but the pole in
/// common, and take it on their parts of its side alone: a plane through it separates them (14.68).
bool are_apart_but_for(const Pole& pole, const RationalPatch& a, const RationalPatch& b);

/// True only if the piece of the patch over a rectangle that reaches the pole takes no value at two different
/// points, the pole on its part of the side apart (14.69).
bool is_injective_but_for(const Pole& pole, const RationalPatch& piece);

/// All pairs of two points on the side, in one node.
Node pole_node(const Pole& pole);

}  // namespace exsect
