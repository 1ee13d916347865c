// The intersection by sections 5 and 6 of docs/method.md alone. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include "answer/run.h"
#include "eliminant/exact_pair.h"

namespace exsect {

/// As intersect() in exact mode, with nothing taken from the solution in doubles.
IntersectResult intersect_exactly(const BezierPatch& x, const BezierPatch& y, const Run& run);

/// The same with turning eliminants of the pair that may be known already.
IntersectResult intersect_exactly(const BezierPatch& x, const BezierPatch& y, const Run& run,
                                  ExactPair& pair);

}  // namespace exsect
