// Means of the first derivatives of a patch over segments in a rectangle. Internal to solver/;
// docs/method.md, sections 14.7 and 14.10.
#pragma once

#include <optional>

#include "filter/patch.h"

namespace exsect::filter {

/// A rectangle of centred parameters.
struct Rectangle {
  std::array<double, 2> lower;
  std::array<double, 2> upper;
};

/// The Taylor coefficients in the middle of a rectangle, and a little more than half its width.
struct RectangleExpansion {
  Coefficients at_middle;
  std::array<double, 2> half;
};
/// Empty where the errors of Taylor coefficients are not bounded.
std::optional<RectangleExpansion> expand(const Patch& patch, const Rectangle& where);

/// row.a is within `deviation` of `middle`, for all means a of a derivative over segments in the rectangle;
/// apart from the errors of the coefficients, which are at most those of Pair::total_error times |row|_1.
struct MeanDerivative {
  double middle;
  double deviation;
};
MeanDerivative mean_first(const RectangleExpansion& x, const Vec3& row);   // of x_u
MeanDerivative mean_second(const RectangleExpansion& x, const Vec3& row);  // of x_v

}  // namespace exsect::filter
