// The intersection of two surfaces given by their equations as a scene.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/solver/surface_intersection.h>

#include <string>

#include "output/drawing/sampled_equation.h"
#include "output/drawing/scene.h"
#include "output/text/surfaces_output.h"

namespace exsect::cli {

/// What is drawn of two surfaces.
struct DrawnSurfaces {
  const SurfaceIntersection& result;
  const ImplicitSurface& first;
  const ImplicitSurface& second;
  const SurfaceNames& names;
};

/// All that is known to be drawn: vertices of polylines, nodes, and of the surfaces the bounded ones. Throws
/// BeyondDoubles.
SpacePoints drawn_points(const DrawnSurfaces& drawn);

/// The curves and nodes, and the surfaces as far as the curves reach (drawing/sampled_equation.h); nothing
/// has parameters. The component of a curve is that of its id in `curves`, the kinds of a node are touch and
/// crossing alone. Throws BeyondDoubles.
Scene surfaces_scene(const DrawnSurfaces& drawn, const std::string& title, int cells);

}  // namespace exsect::cli
