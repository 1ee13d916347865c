// A plane or quadric of revolution over a rectangle of its plane of symmetry, and equations on it. Internal
// to solver/; docs/method.md, section 17.5.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/implicit_surface.h>

#include <optional>

namespace exsect {

/// a(u,v) + b(u,v) y on a chart, with y^2 its radicand.
struct SheetFunction {
  BivariatePolynomial a;
  BivariatePolynomial b;

  bool is_zero() const { return a.is_zero() && b.is_zero(); }
};

/// The points P = origin + u along_u + v along_v + y along_y with y^2 = radicand(u,v) (17.4), u in the place
/// of r and v in that of s; the three directions are orthogonal. Invariant: all points that the surface has
/// in common with the other one have u, v in (0,1), but for what goes on beyond u = 0 and u = 1: the same
/// number of regular arcs for all of these u.
struct SurfaceChart {
  Point origin;
  Point along_u;
  Point along_v;
  Point along_y;
  BivariatePolynomial radicand;  // zero for a plane

  bool is_flat() const { return radicand.is_zero(); }
};

/// A positive multiple with coprime integers as coordinates; zero for zero.
Point shortened(const Point& direction);

/// The function on the chart.
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

}  // namespace exsect
