// On which side of each other two patches lie beside their curves. Internal to solver/; docs/method.md,
// section 8.4.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <functional>

#include "answer/run.h"

namespace exsect {

/// The answer of `solve` for x and y, with Arc::beside, Node::around and Overlap::normals where they are
/// proved, if it is complete. `solve` is called again where only further turning points, which are no nodes
/// of the result, tell in which direction a closed curve runs.
IntersectResult with_signs_beside(const BezierPatch& x, const BezierPatch& y, const Run& run,
                                  const std::function<IntersectResult(const Run&)>& solve);
IntersectResult with_signs_beside(const RationalPatch& x, const RationalPatch& y, const Run& run,
                                  const std::function<IntersectResult(const Run&)>& solve);

}  // namespace exsect
