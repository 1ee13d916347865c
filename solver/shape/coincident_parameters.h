// Parameters that turn together for a reason that the control nets show. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/rational_patch.h>

#include <array>
#include <cstddef>
#include <optional>

namespace exsect {

/// Parameters that turn together (method, 14.13): a linear form of space, or the plane of a pencil of planes
/// through the point, is on x a strictly monotone function of one parameter alone, and on y of another one
/// alone.
struct CoincidentParameters {
  /// Of each parameter that of the other patch, or the parameter itself.
  std::array<std::size_t, 4> partner = {0, 1, 2, 3};
  /// The derivative of the function is zero at this end, 0 or 1, of the parameter; nowhere else in [0,1]. At
  /// a solution there the partner does not change either, if it is in (0,1).
  std::array<std::array<bool, 2>, 4> flat = {};
};
CoincidentParameters coincidence(const RationalPatch& x, const RationalPatch& y);

/// The partners alone.
std::array<std::size_t, 4> coincident_parameters(const RationalPatch& x, const RationalPatch& y);

/// For x and y a coordinate of space in which the normal of the patch is not zero, if the patch lies in a
/// plane: the patch's normal field N is then this coordinate times a constant vector.
std::array<std::optional<std::size_t>, 2> plane_coordinates(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
