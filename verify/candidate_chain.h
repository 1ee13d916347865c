// Candidate curves as chains in space. Internal to verify/; docs/method-verify.md, section 15.
#pragma once

#include <exsect/geometry/candidate.h>

#include "patch_in_doubles.h"
#include "piece_tree.h"

namespace exsect {

/// The curve in space as a chain whose bounds are at most `flat`, unless that takes more than 2^20 pieces.
Chain chain_in_space(const SplineCurve& curve, bool closed, double flat);
/// The curve of the parameter square, mapped into space by the patch; the curve's control points have to be
/// inside the patch's square.
Chain chain_on_patch(const SplineCurve& curve, bool closed, const PatchInDoubles& patch, double flat);

}  // namespace exsect
