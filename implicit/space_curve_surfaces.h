// Pairs of surfaces through a curve of space (docs/method-implicit.md, 10.5).
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/space_polynomial.h>
#include <exsect/implicit/implicit_bounds.h>

#include <array>
#include <optional>
#include <vector>

namespace exsect {

/// x, y, z.
using SpaceBox = std::array<RationalInterval, 3>;

/// Two planar equations of the projections of a curve of space along two coordinate axes: f of the
/// coordinates (axis, second), g of (axis, third), {axis, second, third} = {0, 1, 2}. Polynomials in two
/// variables have the axis as their first.
struct ProjectedPair {
  int axis;
  int second;
  int third;
  BivariatePolynomial f;
  BivariatePolynomial g;
};

/// The common coordinate for Algorithm 2: one that is proved to be strictly monotone along the curve, so that
/// the two cylinders meet near no other point over it; `is_regular` says whether there is one. Else the
/// first coordinate that is not constant and whose two projections are no points. Throws
/// std::invalid_argument for a planar curve or a point.
struct AxisChoice {
  int axis;
  bool is_regular;
};
AxisChoice choose_axis(const BezierCurve& curve);
/// The coordinate has a derivative without zero on [0,1], by Bernstein coefficients.
bool is_strictly_monotone(const BezierCurve& curve, int axis);

/// The exact equations of both projections (Algorithm 2). Throws std::invalid_argument if a projection is a
/// point.
ProjectedPair exact_projections(const BezierCurve& curve, int axis);

/// f or g as a function of (x,y,z): a generalised cylinder.
SpacePolynomial cylinder(const BivariatePolynomial& f, int first_axis, int second_axis);

/// The planar polynomial divided by the mean of |grad f| at points of the curve, in short rationals.
BivariatePolynomial with_unit_gradients(const BivariatePolynomial& f, const BezierCurve& projection);

struct SurfacePair {
  SpacePolynomial first;
  SpacePolynomial second;
};

/// The two cylinders f, g.
SurfacePair cylinders(const ProjectedPair& pair);
/// Algorithm 3: F = h_f g + h_g f, G = h_f g - h_g f with polynomials h_f, h_g near |grad f|, |grad g|. They
/// meet where f = g = 0 and nowhere else as long as h_f and h_g are not zero: F + G = 2 h_f g, F - G = 2 h_g
/// f (10.14).
SurfacePair nearly_orthogonal(const ProjectedPair& pair, const BivariatePolynomial& norm_f,
                              const BivariatePolynomial& norm_g);
/// f and G* = |grad f|^2 g - (grad f . grad g) f: orthogonal wherever f = g = 0 (10.15).
SurfacePair orthogonal(const ProjectedPair& pair);

/// f > 0 on the box, by Bernstein coefficients; false decides nothing.
bool is_positive_on(const BivariatePolynomial& f, const PlanarBox& box);

/// The largest |cos| of the angle between the gradients of two surfaces along a curve.
struct GradientAngle {
  /// Proved (10.16): |cos| <= upper everywhere on the curve; nothing if a gradient vanishes on it or may do
  /// so.
  std::optional<Rational> upper;
  /// |cos| >= lower at some point of the curve.
  Rational lower;
};
GradientAngle largest_cosine(const SurfacePair& surfaces, const BezierCurve& curve);

/// The squared distance of p from the line in which the linear Taylor polynomials of both surfaces at p
/// vanish (10.16a): exact for planes, of first order otherwise. Empty where the gradients are linearly
/// dependent.
std::optional<Rational> first_order_squared_distance(const SurfacePair& surfaces, const Point& p);

/// W^d f(X/W, Y/W, Z/W) for a curve of space, d the total degree of f.
Polynomial composed(const SpacePolynomial& f, const HomogeneousCurve& curve);

}  // namespace exsect
