// Where both patches have one normal and one point, as numbers of a real field. Internal to solver/;
// docs/method-doubles.md, section 14.18.
#pragma once

#include <exsect/algebra/real_field.h>

#include <optional>

#include "filter/exact_patch.h"

namespace exsect::filter {

/// The parameters near w (centred) of the point to which Newton's method leads that filter::common_normal
/// has, to up to a thousand digits, if the patches have it in common so far, and if these digits are those of
/// numbers of one field of degree kMostFieldDegree at most. A guess: nothing is proved.
inline constexpr int kMostFieldDegree = 8;
template <class K>
std::optional<std::array<FieldNumber, 4>> exact_place(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                      const Vec4& w);

}  // namespace exsect::filter
