// The intersection of a surface given by its equation with a patch, exact: a plane curve of the patch's
// parameters. docs/method-equations.md, section 17.1.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/curve_graph.h>

#include <string>
#include <vector>

namespace exsect {

/// What a bound of a surface is called, and its `where` on the patch (geometry/surface_region.h).
struct CurveBound {
  std::string name;
  BivariatePolynomial where;
};

/// Invariant: the points (u,v) of [0,1]^2 with x(u,v) on the surface are those of `graph`, or, if
/// contains_patch, all of `region`, and the graph is empty. A node of degree 0 is
/// where patch and surface touch in a point or meet in a corner or side of the patch alone; an arc of
/// multiplicity above 1 is a curve along which they touch, unless the patch or the equation is singular
/// there.
struct SurfaceCurve {
  BivariatePolynomial section;     // G of (17.2), u in the place of r and v in that of s
  CurveRegion region;              // the same of what bounds the surface
  std::vector<CurveBound> bounds;  // of the bounds in region.clauses
  bool contains_patch = false;
  CurveGraph graph;
};

/// For every patch, of every degree and with weights or without.
SurfaceCurve surface_curve(const ImplicitSurface& surface, const RationalPatch& x);

/// The part of the curve {section = 0} of the patch in a region of space. Requires section != 0; all that
/// the region and names need of the patch is its reduced form.
SurfaceCurve curve_in(const SurfaceRegion& region, BivariatePolynomial section, const RationalPatch& reduced);

/// The bounds with a name that a node of curve.graph lies on: their positions, and their names.
std::vector<std::size_t> bound_positions_at(const SurfaceCurve& curve, std::size_t node);
std::vector<std::string> bounds_at(const SurfaceCurve& curve, std::size_t node);

}  // namespace exsect
