// Means of the first derivatives of a patch over segments in a rectangle. Internal to solver/;
// docs/method-doubles.md, sections 14.7, 14.10 and 14.15.
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
template <class K>
struct RectangleExpansionOf {
  CoefficientsOf<K> at_middle;
  std::array<double, 2> half;
};
using RectangleExpansion = RectangleExpansionOf<Biquadratic>;
/// Empty where the errors of Taylor coefficients are not bounded.
template <class K>
std::optional<RectangleExpansionOf<K>> expand(const PatchOf<K>& patch, const Rectangle& where);

/// row.a is within `deviation` of `middle`, for all means a of a derivative over segments in the rectangle,
/// or for all values a; apart from the errors of the coefficients, which are at most those of
/// Pair::total_error times |row|_1.
struct MeanDerivative {
  double middle;
  double deviation;
};
template <class K>
MeanDerivative mean_first(const RectangleExpansionOf<K>& x, const Row<K>& row);  // of x_u
template <class K>
MeanDerivative mean_second(const RectangleExpansionOf<K>& x, const Row<K>& row);  // of x_v
template <class K>
MeanDerivative mean_value(const RectangleExpansionOf<K>& x, const Row<K>& row);  // of x itself

}  // namespace exsect::filter
