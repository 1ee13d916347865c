// On which side of each other two surfaces given by their equations lie beside their curves. Internal to
// solver/; docs/method-equations.md, section 17.20.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <array>
#include <optional>

#include "lift/lifted_curve.h"
#include "lift/ring_curve.h"
#include "lift/surface_intersection.h"
#include "lift/torus_curve.h"

namespace exsect {

/// On a surface of the chart, of which the curve is: the signs of `other` beside an arc (17.27), exactly.
std::optional<SideSigns> sides_on_chart(const LiftedCurve& curve, const SheetFunction& other, std::size_t arc,
                                        int orientation);
/// 1 if along_u goes to the right and along_v upwards on the surface as it is seen from where its equation is
/// positive, -1 if it is the other way round.
int chart_orientation(const SurfaceChart& chart, const ImplicitSurface& surface);

/// The signs of `other` on the surface beside all arcs, which are those of the curve on it.
void add_sides(SurfaceIntersection& result, const LiftedCurve& curve, const ImplicitSurface& surface,
               const ImplicitSurface& other);
void add_sides(SurfaceIntersection& result, const RingCurve& curve, const ImplicitSurface& surface,
               const ImplicitSurface& other);
void add_sides(SurfaceIntersection& result, const TorusCurve& curve, const ImplicitSurface& surface,
               const ImplicitSurface& other);

/// An arc that leaves a box that holds a point of it along sense (grad f x grad g), where u = height . P
/// grows: the signs (17.28), (17.29) of `second` on `first`; empty where the box does not tell them.
struct ArcStart {
  const SpacePolynomial& f;
  const SpacePolynomial& g;
  int sense;
  const Point& height;
  std::array<RationalInterval, 3> box;
};
std::optional<SideSigns> sides_from(const ArcStart& start, const SpacePolynomial& first,
                                    const SpacePolynomial& second, int multiplicity);

/// Those of the first surface on the second one, from those of the second on the first (17.30).
void exchange_sides(SurfaceIntersection& result, const SpacePolynomial& first, const SpacePolynomial& second);
/// Those of the negative equation.
void negate_sides(SurfaceIntersection& result);

/// The sign of `second` on `first` around isolated points, where it is known (17.31).
void add_sides_around(SurfaceIntersection& result, const SpacePolynomial& first,
                      const SpacePolynomial& second);

/// Of two equations that are proportional: the sign of their quotient.
std::optional<int> sign_of_quotient(const SpacePolynomial& first, const SpacePolynomial& second);

}  // namespace exsect
