// Certified pieces of the curve F = x(u,v) - y(r,s) = 0 in doubles. Internal to solver/;
// docs/method-doubles.md, section 14.2.
#pragma once

#include "answer/parameter_box.h"
#include "filter/polynomial.h"

namespace exsect::filter {

/// All points within `radius` of `middle` in every parameter.
template <class K>
struct BallOf {
  Unknowns<K> middle;
  double radius;
};
using Ball = BallOf<Biquadratic>;

template <class K>
Unknowns<K> filled(double value) {
  Unknowns<K> result;
  result.fill(value);
  return result;
}
template <class K>
Vec4 parameters_of(const BallOf<K>& ball) {
  return {ball.middle[0], ball.middle[1], ball.middle[2], ball.middle[3]};
}

template <class K>
Vec4 first_four(const Unknowns<K>& w) {
  return {w[0], w[1], w[2], w[3]};
}
/// The values from 0 to 1 of a parameter in the ball.
template <class K>
RationalInterval interval(const BallOf<K>& ball, std::size_t parameter);

/// The part of [0,1]^4 within `radius` of a centred place, but for rounding.
ParameterBox box_around(const Vec4& place, double radius);

/// Invariant after `certify`: for every tau in [lower, upper] there is exactly one point w = centre + tau
/// slope + e of F = 0 with e_axis = 0, |e_i| <= halfwidth_i; it satisfies |e_i| <= inner_i < halfwidth_i. The
/// columns of DF other than `axis` are independent on this region: it holds one regular arc, a graph over
/// tau. After `bound_derivatives` also w' in slope +- slope_error, w'' in second +- second_error. In all of
/// it but the centre the scale of weighted patches is relative to that of the centre: w_4 = centre_4 (1 +
/// e_4).
template <class K>
struct TubeOf {
  Unknowns<K> centre;
  std::size_t axis;
  std::array<std::size_t, K::rows> others;
  Unknowns<K> slope;  // 1 at axis
  double lower;
  double upper;
  Unknowns<K> halfwidth;  // 0 at axis
  Unknowns<K> inner;
  double contraction;  // rho: row sum bound of C DF - 1 on the region, < 1

  CoefficientsOf<K> g;      // C x(.)
  CoefficientsOf<K> h;      // -C y(.), of weighted patches times the scale: C F = g + (1 + e_4) h
  CoefficientsOf<K> space;  // x(.)
  Row<K> norm;              // bounds of the row sums of |C|
  Unknowns<K> offset;       // bound of |w_i - centre_i| in the region
  double value_error;       // of every row of C F computed at an offset in the region
  double column_error;      // of every row of every C F_j computed there
  std::array<Row<K>, K::unknowns>
      deviation;  // bounds of |C F_j - C F_j(centre)| + rounding, C F_j(centre) idealised

  Unknowns<K> slope_error;
  Unknowns<K> second;
  Unknowns<K> second_error;
  std::array<Row<K>, 6> further;  // about the coefficients of tau^3, tau^4, ... of w, by rows
};
using Tube = TubeOf<Biquadratic>;

/// Everything about the tube around `centre` that does not depend on its size; false if the columns other
/// than `axis` are numerically dependent, or the centre is not in [-3/4,3/4]^4.
template <class K>
bool prepare(const PairOf<K>& pair, const Unknowns<K>& centre, std::size_t axis, TubeOf<K>& tube);

/// A length in unknown j as one in the tube: that of the scale becomes relative.
template <class K>
double in_tube([[maybe_unused]] const TubeOf<K>& tube, [[maybe_unused]] std::size_t j, double length) {
  if constexpr (K::weighted) {
    if (j == 4) return length / tube.centre[4];
  }
  return length;
}
/// The unknowns at an offset from the centre, but for kSumRounding.
template <class K>
Unknowns<K> place_at(const TubeOf<K>& tube, const Unknowns<K>& offset) {
  Unknowns<K> result;
  for (std::size_t j = 0; j < 4; ++j) result[j] = tube.centre[j] + offset[j];
  if constexpr (K::weighted) result[4] = tube.centre[4] + tube.centre[4] * offset[4];
  return result;
}

/// Half widths for a tube with this residual: twice as wide, at least `least`.
template <class K>
Unknowns<K> halfwidths(const Row<K>& residual, double least) {
  return filled<K>(std::max(2 * largest(residual), least));
}

/// Bound of |C F(centre + tau slope)| for |tau| <= reach, by rows.
template <class K>
Row<K> residual_bound(const PairOf<K>& pair, const TubeOf<K>& tube, double reach);

/// Proves the invariant for these tau and half widths (that of the axis is not used), or returns false.
template <class K>
bool certify(const PairOf<K>& pair, TubeOf<K>& tube, double lower, double upper,
             const Unknowns<K>& halfwidth);
/// The same with the residual bound for these tau.
template <class K>
bool certify(const PairOf<K>& pair, TubeOf<K>& tube, double lower, double upper, const Unknowns<K>& halfwidth,
             const Row<K>& residual);

/// C F at centre + offset.
template <class K>
Row<K> premultiplied_value(const TubeOf<K>& tube, const Unknowns<K>& offset);

/// The point of the curve at tau, in [lower, upper]; `offset` receives the approximate offset from the
/// centre.
template <class K>
BallOf<K> point_at(const TubeOf<K>& tube, double tau, Unknowns<K>* offset);
template <class K>
BallOf<K> point_at(const TubeOf<K>& tube, double tau) {
  return point_at<K>(tube, tau, nullptr);
}

/// True only if all of the ball is in the region: a point of F = 0 known to be in the ball is on the arc.
template <class K>
bool contains(const TubeOf<K>& tube, const BallOf<K>& ball);
/// True only if no point of the ball is on the arc.
template <class K>
bool excludes(const TubeOf<K>& tube, const BallOf<K>& ball);

}  // namespace exsect::filter
