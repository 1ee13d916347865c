// What another program computed for a patch and a surface given by its equation, held against the proved
// intersection. docs/method-verify.md, section 15.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/verify/verify.h>

namespace exsect {

/// As for two patches; `first` of the candidate belongs to the patch x, and the surface has no parameters. In
/// Verification::exact r and s are 0, as in intersect_surface.h, and no gap names them. The tolerance is
/// relative to the extent of x. Throws std::invalid_argument also for a candidate with `second`.
Verification verify(const Candidate& candidate, const ImplicitSurface& surface, const RationalPatch& x,
                    const VerifyOptions& options = {});

}  // namespace exsect
