// Whether one patch is a piece of the other one's polynomial surface, parametrised affinely. Internal to
// solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <optional>

namespace exsect {

/// t -> offset + factor t, factor other than 0.
struct AffineMap {
  Rational offset;
  Rational factor;

  Rational operator()(const Rational& t) const { return offset + factor * t; }
  Rational inverse(const Rational& value) const { return (value - offset) / factor; }
};

/// y(r,s) = x(maps[0](r), maps[1](s)).
struct ShiftedCopy {
  std::array<AffineMap, 2> maps;
};

/// The maps, if there are any and each can be read off: that of r where the direction of x_vv, a quadratic
/// polynomial in u, is not constant, and that of s where the direction of x_uu is not.
std::optional<ShiftedCopy> shifted_copy(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
