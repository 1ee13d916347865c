// Models far from unit size, brought near it by a power of two. Internal to solver/; docs/method-verify.md,
// section 15.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/verify/verdict.h>

namespace exsect {

/// The power of two 2^e by which the patches have to be divided so that squares of distances are doubles: 0
/// as long as the greatest coordinate is between 2^-200 and 2^200, or 0.
int exponent_of_size(const RationalPatch& x, const RationalPatch& y);

/// Divided by 2^e, exactly.
RationalPatch scaled_down(const RationalPatch& x, int e);
/// Divided by 2^e; what underflows in a polyline is added to its bound. Only what a Verifier looks at.
IntersectResult scaled_down(IntersectResult exact, int e);
/// Divided by 2^e, but for what underflows. Throws std::invalid_argument if a coordinate is then beyond
/// max_candidate_number.
Candidate scaled_down(Candidate candidate, int e);

/// All lengths times 2^e, upper bounds rounded up.
Verdict scaled_up(Verdict verdict, int e);

}  // namespace exsect
