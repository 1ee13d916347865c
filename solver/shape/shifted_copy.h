// Whether one patch is a piece of the other one's surface, parametrised affinely. Internal to solver/.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <optional>
#include <vector>

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

/// The maps, if there are any and one of them can be read off (14.40): from the highest derivatives by the
/// other parameter, unless these keep their direction, or from the coordinates, in some coordinate system,
/// that depend on one parameter alone, as two of a height field do. For patches of every bidegree, with
/// weights or without, whatever the degrees that they are written in.
std::optional<ShiftedCopy> shifted_copy(const RationalPatch& x, const RationalPatch& y);

/// Control vectors of a patch whose components have no common factor, row index = first parameter.
using HomogeneousNet = std::vector<std::vector<HomogeneousPoint>>;
/// The same of patches with these nets, neither of which is empty.
std::optional<ShiftedCopy> shifted_copy(const HomogeneousNet& x, const HomogeneousNet& y);

}  // namespace exsect
