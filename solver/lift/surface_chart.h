// A plane or quadric of revolution over a rectangle of its plane of symmetry, or a half of a torus over one,
// and equations on it. Internal to solver/; docs/method-equations.md, sections 17.5 and 17.14.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/implicit_surface.h>

#include <optional>
#include <vector>

namespace exsect {

/// a(u,v) + b(u,v) y on a chart, with y^2 its radicand.
struct SheetFunction {
  BivariatePolynomial a;
  BivariatePolynomial b;

  bool is_zero() const { return a.is_zero() && b.is_zero(); }
};

/// The points P = origin + H along_u + W ((v - middle) along_v + y along_y) with y^2 = radicand(u,v) (17.4),
/// u in the place of r and v in that of s, and H, W > 0 the quotients of `height` and `width` by
/// `denominator`, all three functions of u of degree at most 2: H = u and W = 1, but on tori. The three
/// directions are orthogonal. Invariant, unless it is a torus: all points that the surface has in common with
/// the other one have u, v in (0,1), but for what goes on beyond u = 0 and u = 1: the same number of regular
/// arcs for all of these u.
struct SurfaceChart {
  Point origin;
  Point along_u;
  Point along_v;
  Point along_y;
  BivariatePolynomial radicand;  // zero for a plane
  Polynomial height = {0, 1};
  Polynomial width = 1;
  Polynomial denominator = 1;
  Rational middle = 0;

  bool is_flat() const { return radicand.is_zero(); }
  bool is_affine() const { return denominator.degree() < 1; }
};

/// A positive multiple with coprime integers as coordinates; zero for zero.
Point shortened(const Point& direction);

/// The function on the chart, times the power of the denominator with f's degree.
SheetFunction on_chart(const SpacePolynomial& f, const SurfaceChart& chart);

/// Of a plane, if the other surface is a torus or a polynomial, and of a sphere, cylinder or cone with both
/// nappes. The direction along_y is orthogonal to a common plane of symmetry, if there is one. Empty for
/// others. Beyond u = 0 and u = 1 none of the region's bounds with a name is zero on the curve, unless it is
/// along an arc.
std::optional<SurfaceChart> chart_of(const ImplicitSurface& surface, const ImplicitSurface& other,
                                     const SurfaceRegion& region);

/// The curve {a + b y = 0} seen along y: common {norm = 0} with the common factor of a and b and norm =
/// a^2 - radicand b^2 (17.5) for the rest; on a plane norm = a.
struct Shadow {
  SheetFunction rest;  // a and b without their common factor
  BivariatePolynomial common;
  BivariatePolynomial norm;
};
/// Requires f != 0.
Shadow shadow(const SheetFunction& f, const SurfaceChart& chart);
/// common * norm: the points that have one with f = 0 above or below them. Zero for f = 0.
BivariatePolynomial whole_shadow(const SheetFunction& f, const SurfaceChart& chart);
/// What a curve on the chart is cut by: the zeros of y, and of bounds with a name.
std::vector<BivariatePolynomial> cuts_of(const SurfaceRegion& region, const SurfaceChart& chart);

}  // namespace exsect
