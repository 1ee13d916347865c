// Solutions on sides of both patches, or in a corner, proved in rational numbers. Internal to solver/;
// docs/method-doubles.md, section 14.12.
#pragma once

#include <exsect/algebra/real_field.h>

#include <array>
#include <optional>

#include "filter/exact_patch.h"
#include "filter/part.h"

namespace exsect::filter {

/// A solution within `radius` of `at` (centred) in every parameter; those that are at sides are exact. If
/// still[j], the tangent (5.1) has no component j there, exactly.
struct ExactMeeting {
  Vec4 at;
  double radius;
  std::array<bool, 4> still;
  std::optional<std::array<FieldNumber, 4>> exact = std::nullopt;  // in [0,1], if they are known
};

/// The solution near a place (centred) that has the parameters with on[j] != 0 at these sides, 1/2 or -1/2,
/// if the other ones are simple rational numbers, or there is one side of each patch and both lie in one
/// plane. Empty if neither of these proves that there is one.
template <class K>
std::optional<ExactMeeting> exact_meeting(const ExactPatch<K>& x, const ExactPatch<K>& y, const Vec4& place,
                                          const Vec4& on);

}  // namespace exsect::filter
