// Two pieces of one surface of any kind that is not injective on them. Internal to solver/;
// docs/method-doubles.md, section 14.15.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include "answer/run.h"

namespace exsect {

/// The intersection if y is x in other parameters, affine functions or Moebius maps of x's, their squares
/// share a rectangle, and the surface over both meets itself in poles alone, or both patches are the same but
/// for the names and directions of their parameters. Otherwise, or where that is not proved, an incomplete
/// result without a graph.
IntersectResult intersect_rational_pieces(const RationalPatch& x, const RationalPatch& y, const Run& run);

}  // namespace exsect
