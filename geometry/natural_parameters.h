// The natural parameters of points of round surfaces, as of faces (surface_box.h), enclosed.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <array>
#include <optional>

namespace exsect {

/// Angles are in whole turns, from 0 to 1; an interval about 0 has negative numbers for what is just short of
/// a whole turn.
///
/// `turn`: about the axis, counter-clockwise when it points to the eye, from the direction of the first
/// coordinate axis to which it is the least inclined (x for an axis along z or y or (1,1,1), y for one along
/// x). `height`: over the point of the surface, in multiples of the axis. `tube`: of a torus, about the
/// circle of the tube's centres, from outwards to the axis.
struct NaturalParameters {
  std::optional<RationalInterval> turn = {};
  std::optional<RationalInterval> height = {};
  std::optional<RationalInterval> tube = {};
};

/// Those of the points of the surface in the box: turn and height on cylinders and cones, the same on spheres
/// about the axis of their box, (0,0,1) for whole ones, turn and tube on tori, nothing on planes and
/// polynomials. Without a turn where the box meets the axis. Requires that there is such a point.
NaturalParameters natural_parameters(const ImplicitSurface& surface,
                                     const std::array<RationalInterval, 3>& box);

}  // namespace exsect
