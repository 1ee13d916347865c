// Faces of round surfaces: boxes of their natural parameters, given exactly. docs/method-equations.md,
// section 17.8.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <array>
#include <optional>

namespace exsect {

/// The angles about an axis from the half plane that the axis bounds and `from` points into to that of `to`,
/// counter-clockwise when the axis points to the eye. Only the parts orthogonal to the axis count.
struct AxisSector {
  Point from;
  Point to;
};

/// Heights over the point that the surface is given by (a cone's apex, a centre), in multiples of the axis.
struct HeightRange {
  Rational from;
  Rational to;
};

/// The angles of a torus about the circle of its tube's centres, from one direction to another,
/// counter-clockwise from outwards to the axis: (c,s) is c times the major radius outwards and s times the
/// axis.
struct TubeSector {
  std::array<Rational, 2> from;
  std::array<Rational, 2> to;
};

/// A closed box: all that are given hold. Cylinders and cones have sectors and heights, spheres also with
/// the axis that these are about, tori also the tube's. On a plane it is the parallelogram of the point and
/// two sides, orthogonal to the normal.
struct SurfaceBox {
  std::optional<Point> axis = {};
  std::optional<AxisSector> sector = {};
  std::optional<HeightRange> height = {};
  std::optional<TubeSector> tube = {};
  std::optional<std::array<Point, 2>> sides = {};
};

/// The part of a whole surface in the box, with bounds "sector=from", "sector=to", "height=from",
/// "height=to", "tube=from", "tube=to", and "first=0", "first=1", "second=0", "second=1" for multiples of the
/// sides. Throws SurfaceError, with places as "box.sector.from", for what a surface of this kind does not
/// have, a side or direction that is none, and heights and sectors without inner points or without an end;
/// and std::invalid_argument for a surface that is in a box already.
ImplicitSurface boxed(const ImplicitSurface& whole, const SurfaceBox& box);

/// (a, b, c) of the form a x + b y + c z + d of a bound.
Point gradient(const SpacePolynomial& linear);

/// The axis of the box of a sphere, as it was given to boxed(); empty without a box of a sphere.
std::optional<Point> axis_of_box(const ImplicitSurface& surface);

}  // namespace exsect
