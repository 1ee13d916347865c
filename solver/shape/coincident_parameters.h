// Parameters that turn together for a reason that the control nets show. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <cstddef>
#include <optional>

namespace exsect {

/// For each parameter the parameter of the other patch that turns at the same points for a proved reason, or
/// the parameter itself: there is a linear form of space that on x is a strictly monotone function of the one
/// alone, and on y of the other alone.
std::array<std::size_t, 4> coincident_parameters(const BezierPatch& x, const BezierPatch& y);

/// For x and y a coordinate of space in which the normal of the patch is not zero, if the patch lies in a
/// plane: the patch's normal field N is then this coordinate times a constant vector.
std::array<std::optional<std::size_t>, 2> plane_coordinates(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
