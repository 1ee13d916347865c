// The intersection in exact mode where doubles find its curves: the turning eliminant proves that they are
// all. Internal to solver/; docs/method-doubles.md, section 14.8.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>

#include "answer/run.h"
#include "eliminant/exact_pair.h"

namespace exsect {

/// The complete intersection; empty if doubles do not find it or the eliminant does not prove that nothing is
/// missing: then `turning`, of this pair, may hold its eliminant. Throws ProofFailure if the two proofs
/// contradict each other.
std::optional<IntersectResult> confirmed_curves(const BezierPatch& x, const BezierPatch& y, const Run& run,
                                                ExactPair& pair);

}  // namespace exsect
