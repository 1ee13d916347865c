// Where in space a point lies that is known by a box of its parameters.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/parameter.h>

#include <array>
#include <string>
#include <vector>

namespace exsect::cli {

/// Intervals of x, y and z.
using SpaceBox = std::array<RationalInterval, 3>;

/// A box of space that contains the point x(u,v) = y(r,s) of which (u,v,r,s) lies in `box`: what the control
/// points of both pieces enclose. Requires that there is such a point.
SpaceBox space_box(const ParameterBox& box, const RationalPatch& x, const RationalPatch& y);

/// The same for a point of x alone.
SpaceBox space_box(const ParameterBox& box, const RationalPatch& x);

/// Proved digits (proved_decimal.h) of u, v, r, s, x, y, z for each box: at most `decimals` decimals of a
/// parameter, and as many of a coordinate after the first digit of the largest coordinate of all.
std::vector<std::vector<std::string>> place_rows(const std::vector<ParameterBox>& boxes,
                                                 const RationalPatch& x, const RationalPatch& y,
                                                 int decimals);
/// The same of u, v, x, y, z for points of x alone.
std::vector<std::vector<std::string>> place_rows(const std::vector<ParameterBox>& boxes,
                                                 const RationalPatch& x, int decimals);

/// Decimals on the screen, and with --verbose.
constexpr int shown_decimals(bool verbose) { return verbose ? 15 : 6; }

}  // namespace exsect::cli
