// Two pieces of one polynomial surface. Internal to solver/; docs/method.md, section 6.3.
#pragma once

#include <array>
#include <optional>

#include "shape/shifted_copy.h"

namespace exsect {

/// y(r,s) = x(maps[0](r), maps[1](s)), and where the two pieces lie.
struct TwoPieces {
  BezierPatch x;
  BezierPatch y;
  ShiftedCopy copy;
  std::array<AffineMap, 2>
      around;  // from [0,1]² to the smallest rectangle of (u,v) that contains both pieces

  /// x over that rectangle.
  BezierPatch hull() const;
};

/// Empty if y is no such piece.
std::optional<TwoPieces> two_pieces(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
