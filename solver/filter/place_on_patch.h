// Where a point of space lies on a patch, approximately. Internal to solver/.
#pragma once

#include <array>

#include "filter/patch.h"

namespace exsect::filter {

/// Centred parameters of a patch.
using Place = std::array<double, 2>;

/// The (a,b) for which a p + b q is nearest to v.
Place coordinates(const Vec3& p, const Vec3& q, const Vec3& v);

/// Newton's method from `at` for the place of a point, inside the square or not; false if the point does not
/// lie on the surface, or is not found. A guess: nothing is proved.
template <class K>
bool improve_place(const PatchOf<K>& patch, Place& at, const Vec3& point);

}  // namespace exsect::filter
