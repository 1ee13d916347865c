// Pairs of which a side of one patch is one point, which lies on the other patch. Internal to solver/;
// docs/method-doubles.md, section 14.24.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <optional>

#include "answer/run.h"
#include "filter/magnified_box.h"

namespace exsect {

/// The intersection, if it is proved near such a side and `solve` completes that of the rest of this patch
/// with the other one; empty otherwise.
std::optional<IntersectResult> intersect_at_pole(const RationalPatch& x, const RationalPatch& y,
                                                 const Run& run, const filter::SolvePieces& solve);

}  // namespace exsect
