// A pair of patches in doubles, with proved bounds of every rounding error. Internal to solver/; the notation
// is that of docs/method-doubles.md, section 14.
//
// Everything is scaled to size 1; the roundings, underflow included, are covered by the constants of
// filter/error_bounds.h.
#pragma once

#include <exsect/algebra/nearest_double.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <optional>

#include "answer/model_scale.h"
#include "filter/error_bounds.h"
#include "filter/exact_patch.h"
#include "filter/kind.h"

namespace exsect::filter {

/// One patch, scaled: all |coordinates| of control points are at most 1.
template <class K>
struct PatchOf {
  CoefficientsOf<K> net;    // row index = first parameter
  CoefficientsOf<K> power;  // in h = u - 1/2, k = v - 1/2
  /// For all |h|, |k| <= kReach: expand() errs by less than error[i] in every coordinate of coefficient i,
  /// and the values computed from the coefficients c by at most kValueRoundings each that contain c as a
  /// factor (products with numbers of size at most 1) err by less than the sum of the error[i].
  std::array<double, K::count> error;
};
using Patch = PatchOf<Biquadratic>;

/// The Taylor coefficients of the patch at (h,k): that of (u - 1/2 - h)^i (v - 1/2 - k)^j at index side i +
/// j.
template <class K>
CoefficientsOf<K> expand(const PatchOf<K>& patch, double h, double k);

template <class K>
struct PairOf {
  PatchOf<K> x;
  PatchOf<K> y;
  ModelFrame frame;  // space point = origin + 2^exponent (scaled point)
  double extent;     // of the common bounding box, unscaled, up to rounding
  /// Bound of the error of every coordinate of a subdivided net, to kDeepestLevel levels.
  double net_error;
  /// Sums of x.error and y.error: order_error[n] over i + j = n; `total` over all, with weight 1 + i + j.
  std::array<double, K::orders> order_error;
  double total_error;
  /// Of weighted patches the same of x and of y alone; y counts as often as the scale says.
  std::array<double, K::weighted ? K::orders : 0> x_order_error;
  std::array<double, K::weighted ? K::orders : 0> y_order_error;
  double x_total_error;
  double y_total_error;
};
using Pair = PairOf<Biquadratic>;

/// Empty for coordinates beyond the range in which the error bounds hold: those of size 2^300 and more, or
/// 2^40 and more times the half of the extent, and extents below 2^-300.
template <class K>
std::optional<PairOf<K>> make_pair_of(const ExactPatch<K>& x, const ExactPatch<K>& y);
inline std::optional<Pair> make_pair(const BezierPatch& x, const BezierPatch& y) {
  return make_pair_of<Biquadratic>(x, y);
}

}  // namespace exsect::filter
