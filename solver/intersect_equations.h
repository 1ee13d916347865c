// The exact, complete intersection of two surfaces given by their equations.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/solver/options.h>
#include <exsect/solver/surface_intersection.h>

namespace exsect {

/// Every common point of the two surfaces (method, sections 17.5 to 17.17), whole ones or in boxes: complete
/// for two of plane, cylinder, cone and sphere, for one of them and a torus, for two tori about one axis
/// whose major radii have a rational ratio, for a plane, cylinder, cone or sphere and a polynomial, and with
/// a torus or a polynomial for a torus whose minor radius has a rational ratio to the major one, or to the
/// length of its axis. Other tori and two polynomials are complete unless both are singular along one curve,
/// or of order 3 or more in one point; else they are incomplete, and the reason says so.
/// Of the answer only the sides depend on the order of the surfaces. Polylines keep within the tolerance
/// times the extent of what is drawn; unbounded curves are cut off, where nothing but arcs that go on to
/// infinity is beyond. One surface in two boxes is complete. Of the options the work cap, the tolerance and
/// the progress are taken, errors are those of intersect() for two patches.
SurfaceIntersection intersect(const ImplicitSurface& first, const ImplicitSurface& second,
                              const IntersectOptions& options = {});

}  // namespace exsect
