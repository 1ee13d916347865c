// Points of curves along which the patches touch. Internal to solver/.
#pragma once

#include "star/singular_points.h"

namespace exsect {

/// True only if the point is a regular point of a curve along which the patches touch, and this is not
/// tangent there to a side that the point lies on. Such a point needs no star.
template <class Ball>
bool is_on_contact(const SingularPointQuery& query, const PairSystem<Ball>& system,
                   const CertifiedPoint& point);

}  // namespace exsect
