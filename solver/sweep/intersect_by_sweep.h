// The exact intersection of two surfaces that are not on one surface. Internal to solver/; docs/method.md,
// section 8.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include "answer/run.h"
#include "eliminant/exact_pair.h"

namespace exsect {

/// The sweep: boundary points, turning eliminant, fibres, curves, stars, graph, from exact data alone.
/// `turning` is of this pair.
/// Precondition: both patches are surfaces, and not pieces of one surface.
IntersectResult intersect_by_sweep(const BezierPatch& x, const BezierPatch& y, const Run& run,
                                   ExactPair& pair);

}  // namespace exsect
