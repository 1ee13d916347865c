// Poles, sides that are one point, of both patches at the same point. Internal to solver/;
// docs/method-doubles.md, section 14.24.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <optional>
#include <vector>

#include "special/pole_arcs.h"

namespace exsect {

/// The sides (0,t) of x and (0,s) of y are the same point.
bool have_common_pole(const RationalPatch& x, const RationalPatch& y);

/// All arcs of x(a,t) = y(b,s) over 0 < a <= reach, with (r,s) = (b,s): each begins in the pole, and there is
/// nothing else but the pole with t and s free. `turning`: of (a,t,b,s) as (u,v,r,s). Empty if that is not
/// proved. Requires a common pole and 0 < reach < 1.
std::optional<std::vector<PoleArc>> arcs_at_common_pole(const RationalPatch& x, const RationalPatch& y,
                                                        const Rational& reach,
                                                        const std::vector<Parameter>& turning);

}  // namespace exsect
