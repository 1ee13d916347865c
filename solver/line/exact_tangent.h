// Which components of the tangent field vanish at an exact point. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <array>

namespace exsect {

/// Per parameter: the component of the field (5.1) of docs/method.md is zero at the point, decided in its
/// field of numbers.
std::array<bool, 4> zero_tangent_components(const BezierPatch& x, const BezierPatch& y,
                                            const ExactParameters& point);

}  // namespace exsect
