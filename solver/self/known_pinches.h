// Points of a patch at which its derivatives are dependent, exactly: on the sides, and on lines inside along
// or across which the patch rests there. Internal to solver/; docs/method-doubles.md, section 14.17.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/rational_patch.h>

#include <array>
#include <cstddef>
#include <vector>

#include "shape/injective_rectangle.h"

namespace exsect {

/// x_u x x_v = 0 where the parameter `fixed`, 0 or 1 for u or v, has the value, and the other one is `at`.
struct KnownPinch {
  std::size_t fixed;
  Rational value;
  RealAlgebraic at;
  std::array<bool, 2> rests;         // x_u = 0, x_v = 0
  bool is_on_straight_line = false;  // all of this parameter line is straight in space

  bool is_on_side() const { return value == 0 || value == 1; }
};

/// All of them on the sides, but none on a side on which every point is one; a corner may be listed for both
/// of its sides. Of those inside near one of the places, (u,v) in doubles, some with x_u = 0 or x_v = 0.
std::vector<KnownPinch> known_pinches(const RationalPatch& patch,
                                      const std::vector<std::array<double, 2>>& places);

/// The closed rectangle contains the point.
bool contains(const ParameterRectangle& where, const KnownPinch& pinch);

}  // namespace exsect
