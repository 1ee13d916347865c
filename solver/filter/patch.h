// A pair of patches in doubles, with proved bounds of every rounding error. Internal to solver/; the notation
// is that of docs/method.md, section 14.
//
// Everything is scaled to size 1; the roundings, underflow included, are covered by the constants of
// filter_error_bounds.h.
#pragma once

#include <exsect/algebra/nearest_double.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <optional>

#include "answer/model_scale.h"
#include "filter/error_bounds.h"

namespace exsect::filter {

using Vec3 = std::array<double, 3>;
/// Parameters (u,v,r,s), each minus 1/2: the domain is [-1/2,1/2]^4.
using Vec4 = std::array<double, 4>;
/// Coefficients of a biquadratic vector polynomial, that of h^i k^j at index 3 i + j.
using Coefficients = std::array<Vec3, 9>;

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec3 operator*(double t, const Vec3& a) { return {t * a[0], t * a[1], t * a[2]}; }
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double largest(const Vec3& a) { return std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])}); }

/// One patch, scaled: all |coordinates| of control points are at most 1.
struct Patch {
  std::array<Vec3, 9> net;  // row index = first parameter
  Coefficients power;       // in h = u - 1/2, k = v - 1/2
  /// For all |h|, |k| <= kReach: expand() errs by less than error[i] in every coordinate of coefficient i,
  /// and the values computed from the coefficients c by at most 20 roundings each that contain c as a factor
  /// (products with numbers of size at most 1) err by less than the sum of the error[i].
  std::array<double, 9> error;
};

/// The Taylor coefficients of the patch at (h,k): coefficient 3 i + j is that of (u - 1/2 - h)^i (v - 1/2 -
/// k)^j.
Coefficients expand(const Patch& patch, double h, double k);

struct Pair {
  Patch x;
  Patch y;
  ModelFrame frame;  // space point = origin + 2^exponent (scaled point)
  double extent;     // of the common bounding box, unscaled, up to rounding
  /// Bound of the error of every coordinate of a subdivided net, to kDeepestLevel levels.
  double net_error;
  /// Sums of x.error and y.error: order_error[n] over i + j = n; `total` over all, with weight 1 + i + j.
  std::array<double, 5> order_error;
  double total_error;
};

/// Empty for coordinates beyond the range in which the error bounds hold: those of size 2^300 and more, or
/// 2^40 and more times the half of the extent, and extents below 2^-300.
std::optional<Pair> make_pair(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect::filter
