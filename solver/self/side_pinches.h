// Points on the sides of a patch at which its derivatives are dependent, exactly. Internal to solver/;
// docs/method-doubles.md, section 14.17.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/rational_patch.h>

#include <cstddef>
#include <vector>

#include "shape/injective_rectangle.h"

namespace exsect {

/// x_u x x_v = 0 where the parameter `fixed`, 0 or 1 for u or v, has the value 0 or 1, and the other one is
/// `at`.
struct SidePinch {
  std::size_t fixed;
  int value;
  RealAlgebraic at;
  bool along;  // the derivative along the side is 0
};

/// All of them, but none on a side on which every point is one. A corner may be listed for both of its sides.
std::vector<SidePinch> side_pinches(const RationalPatch& patch);

/// The closed rectangle contains the point.
bool contains(const ParameterRectangle& where, const SidePinch& pinch);

}  // namespace exsect
