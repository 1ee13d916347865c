// Solutions on sides of both patches that are not rational, proved in algebraic numbers. Internal to solver/;
// docs/method-doubles.md, section 14.12.
#pragma once

#include "filter/exact_meeting.h"

namespace exsect::filter {

/// As exact_meeting, where one side of each patch meet, or a corner of one patch lies on a side of the other
/// one. Empty also where the sides have a curve in common. Where a component of the tangent is zero, the
/// parameters are told exactly, if they are numbers of one field of a small degree.
std::optional<ExactMeeting> algebraic_meeting(const RationalPatch& x, const RationalPatch& y,
                                              const Vec4& place, const Vec4& on);

}  // namespace exsect::filter
