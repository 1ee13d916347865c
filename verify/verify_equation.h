// What another program computed for a surface given by its equation and a patch, or another such surface,
// held against the proved intersection. docs/method-verify.md, section 15.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/solver/surface_intersection.h>
#include <exsect/verify/verify.h>

#include <stdexcept>

namespace exsect {

/// As for two patches; `first` of the candidate belongs to the patch x, and the surface has no parameters. In
/// Verification::exact r and s are 0, as in intersect_surface.h, and no gap names them. The tolerance is
/// relative to the extent of x. Throws std::invalid_argument also for a candidate with `second`.
Verification verify(const Candidate& candidate, const ImplicitSurface& surface, const RationalPatch& x,
                    const VerifyOptions& options = {});

/// What no candidate can be compared with: "a common curve goes on to infinity, ...".
class NotComparable : public std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

struct EquationsVerification : Verification {
  SurfaceIntersection surfaces;  // what `exact` is the graph of
};

/// As for two patches; the candidate states points of space alone. In Verification::exact all parameters are
/// 0, and nodes and arcs have the ids of those of `surfaces`. The tolerance is relative to the largest extent
/// of the common points, 1 for a single one. Throws NotComparable also for a candidate with parameters,
/// and where a common curve goes on to infinity or the surfaces are one.
EquationsVerification verify(const Candidate& candidate, const ImplicitSurface& first,
                             const ImplicitSurface& second, const VerifyOptions& options = {});

}  // namespace exsect
