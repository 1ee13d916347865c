// Parameter lines of one patch that are one curve of space. Internal to solver/; docs/method-doubles.md,
// section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <optional>

#include "shape/injective_rectangle.h"

namespace exsect {

/// (14.67): two different real numbers t1, t2, the roots of a polynomial t^2 - sum t + product, with
/// x(t1,v) = x(t2,v) for all v, or x(u,t1) = x(u,t2) for all u.
struct CoincidentLines {
  std::size_t fixed;  // the parameter with these values: 0 or 1
  Rational sum;
  Rational product;

  /// One of the lines passes through the inside of each of two rectangles without a common point, and there
  /// is a piece of the lines, of positive length, with the same other parameter in both.
  bool pass(const ParameterRectangle& first, const ParameterRectangle& second) const;
};

/// Empty if there is none, or more than one, such pair of values of this parameter (0, 1).
std::optional<CoincidentLines> coincident_lines(const RationalPatch& patch, std::size_t fixed);

}  // namespace exsect
