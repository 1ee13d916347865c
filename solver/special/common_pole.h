// Poles, sides that are one point, of both patches at the same point. Internal to solver/;
// docs/method-doubles.md, section 14.24.
#pragma once

#include <exsect/geometry/rational_patch.h>

namespace exsect {

/// The sides (0,t) of x and (0,s) of y are the same point.
bool have_common_pole(const RationalPatch& x, const RationalPatch& y);

/// x(a,t) = y(b,s) has no solution with 0 < a <= reach; false if that is not proved. Requires a common pole
/// and 0 < reach < 1.
bool meet_in_pole_alone(const RationalPatch& x, const RationalPatch& y, const Rational& reach);

}  // namespace exsect
