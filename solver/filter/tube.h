// Certified pieces of the curve F = x(u,v) - y(r,s) = 0 in doubles. Internal to solver/; docs/method.md,
// section 14.2.
#pragma once

#include "filter/patch.h"

namespace exsect::filter {

/// All points within `radius` of `middle` in every parameter.
struct Ball {
  Vec4 middle;
  double radius;
};

/// The values from 0 to 1 of a parameter in the ball.
RationalInterval interval(const Ball& ball, std::size_t parameter);

/// F and its derivatives at a point, approximately.
struct Linearisation {
  Vec3 value;
  std::array<Vec3, 4> column;  // F_u, F_v, F_r, F_s
  Vec4 tangent;                // (5.1)
};
Linearisation linearise(const Coefficients& x, const Coefficients& y);

/// Where in the tangent the largest component is, each divided by its weight.
std::size_t steepest(const Vec4& tangent, const Vec4& weight = {1, 1, 1, 1});

/// Invariant after `certify`: for every tau in [lower, upper] there is exactly one point w = centre + tau
/// slope + e of F = 0 with e_axis = 0, |e_i| <= halfwidth_i; it satisfies |e_i| <= inner_i < halfwidth_i. The
/// columns of DF other than `axis` are independent on this region: it holds one regular arc, a graph over
/// tau. After `bound_derivatives` also w' in slope +- slope_error, w'' in second +- second_error.
struct Tube {
  Vec4 centre;
  std::size_t axis;
  std::array<std::size_t, 3> others;
  Vec4 slope;  // 1 at axis
  double lower;
  double upper;
  Vec4 halfwidth;  // 0 at axis
  Vec4 inner;
  double contraction;  // rho: row sum bound of C DF - 1 on the region, < 1

  Coefficients g;                 // C x(.)
  Coefficients h;                 // -C y(.)
  Coefficients space;             // x(.)
  Vec3 norm;                      // bounds of the row sums of |C|
  Vec4 offset;                    // bound of |w_i - centre_i| in the region
  double value_error;             // of every row of C F computed at an offset in the region
  double column_error;            // of every row of every C F_j computed there
  std::array<Vec3, 4> deviation;  // bounds of |C F_j - C F_j(centre)| + rounding, C F_j(centre) idealised

  Vec4 slope_error;
  Vec4 second;
  Vec4 second_error;
  std::array<Vec3, 6> further;  // about the coefficients of tau^3, tau^4, ... of w, by rows
};

/// Everything about the tube around `centre` that does not depend on its size; false if the columns other
/// than `axis` are numerically dependent, or the centre is not in [-3/4,3/4]^4.
bool prepare(const Pair& pair, const Vec4& centre, std::size_t axis, Tube& tube);

/// Bound of |C F(centre + tau slope)| for |tau| <= reach, by rows.
Vec3 residual_bound(const Pair& pair, const Tube& tube, double reach);

/// Proves the invariant for these tau and half widths (that of the axis is not used), or returns false.
bool certify(const Pair& pair, Tube& tube, double lower, double upper, const Vec4& halfwidth);
/// The same with the residual bound for these tau.
bool certify(const Pair& pair, Tube& tube, double lower, double upper, const Vec4& halfwidth,
             const Vec3& residual);

void bound_derivatives(const Pair& pair, Tube& tube);

/// |p''(w)[w',w'] - p''(0)[d,d]| for |w_0| <= h[0], |w_1| <= h[1], w' in d +- delta; p has the magnitudes of
/// coefficients c, the errors of which are left out.
Vec3 quadratic_deviation(const Coefficients& c, const double* d, const double* delta, const double* h);

/// sum c[3 i + j] a^i b^j.
Vec3 value_at(const Coefficients& c, double a, double b);

/// C F at centre + offset.
Vec3 premultiplied_value(const Tube& tube, const Vec4& offset);

/// The point of the curve at tau, in [lower, upper]; `offset` receives the approximate offset from the
/// centre.
Ball point_at(const Tube& tube, double tau, Vec4* offset = nullptr);

/// True only if all of the ball is in the region: a point of F = 0 known to be in the ball is on the arc.
bool contains(const Tube& tube, const Ball& ball);
/// True only if no point of the ball is on the arc.
bool excludes(const Tube& tube, const Ball& ball);

/// Newton's method in the parameters other than `axis`, at most `steps` times; a guess and no more. False if
/// it leaves [-3/4,3/4]^4.
bool improve(const Pair& pair, Vec4& point, std::size_t axis, int steps);

}  // namespace exsect::filter
