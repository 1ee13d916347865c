// Two pieces of one surface of any kind that is not injective on them. Internal to solver/;
// docs/method-doubles.md, section 14.15.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include "answer/run.h"

namespace exsect {

/// The intersection if y is x in other parameters, affine functions or Moebius maps of x's, their squares
/// share a rectangle, and it is decided where the surface over the rectangle around both meets itself.
/// Otherwise an incomplete result without a graph.
IntersectResult intersect_rational_pieces(const RationalPatch& x, const RationalPatch& y, const Run& run);

}  // namespace exsect
