// Rectangles of the parameter square on which a patch is proved to be injective, exactly. Internal to
// solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <vector>

namespace exsect {

/// [u0,u1] x [v0,v1], not empty.
struct ParameterRectangle {
  RationalInterval u;
  RationalInterval v;
};

/// True only if x takes no value at two different points of the rectangle, apart from two points on one side
/// of the square that x collapses to a point, by (7.9) and (7.10) (method, section 7.4). Cuspidal points may
/// lie on its sides.
bool is_injective(const BezierPatch& x, const ParameterRectangle& where);

/// Whether x maps the side of the square, fixed parameter 0 (u) or 1 (v), value 0 or 1, to one point.
bool is_collapsed_side(const BezierPatch& x, std::size_t fixed, int value);

/// Rectangles on which x is proved to be injective: along every side that is cuspidal as a whole
/// (`along_sides`: fixed parameter and value), and in every corner that is a cuspidal point. Those that are
/// not proved are left out.
struct InjectiveRectangles {
  std::vector<ParameterRectangle> rectangles;
  std::vector<std::array<int, 2>> along_sides;

  bool along(std::size_t fixed, int value) const;
};
InjectiveRectangles injective_rectangles(const BezierPatch& x);

/// x_u x x_v = 0 all along the side.
bool is_cuspidal_side(const BezierPatch& x, std::size_t fixed, int value);

}  // namespace exsect
