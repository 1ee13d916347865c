// The intersection of a pair of which a patch has an inverse, as a curve of the other one's parameters.
// Internal to solver/; docs/method-equations.md, section 17.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <optional>

#include "answer/run.h"

namespace exsect {

/// By an equation on one of them, if the other one has an inverse; empty where that decides nothing. The
/// curve of less degree first, those that go through a pole of the patch with the inverse last.
std::optional<IntersectResult> intersect_as_curve(const RationalPatch& x, const RationalPatch& y,
                                                  const Run& run);

}  // namespace exsect
