// Parameter lines of two patches that are one curve out of a common pole. Internal to solver/;
// docs/method-doubles.md, section 14.24.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <optional>

namespace exsect {

/// x(a,t) = y(b,s) with b = ratio a / (1 + bend a), for all a with 1 + bend a > 0; ratio > 0.
struct CommonRay {
  Rational t, s;
  Rational ratio, bend;
  bool is_contact;  // the patches touch all along it
};

/// Requires that the sides (0,t) of x and (0,s) of y are the same point, and D, E, the directions of x and y
/// in it at t and s, are not 0. Empty if these lines are not one curve in one direction up to such a map
/// (14.140).
std::optional<CommonRay> common_ray(const RationalPatch& x, const RationalPatch& y, const Rational& t,
                                    const Rational& s);

}  // namespace exsect
