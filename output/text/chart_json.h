// The natural parameters of nodes on round surfaces, in JSON (docs/formats.md).
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>
#include <exsect/solver/surface_intersection.h>

#include "output/text/json_forms.h"

namespace exsect::cli {

/// Adds `chart` to the nodes of what intersection_json() gives for x and a surface by its equation, where it
/// has natural parameters.
void add_charts(Json& json, const IntersectionGraph& graph, const RationalPatch& x,
                const ImplicitSurface& surface);
/// Adds `charts` to the nodes of what surfaces_json() gives: those of the first and of the second surface.
void add_charts(Json& json, const SurfaceIntersection& result, const ImplicitSurface& first,
                const ImplicitSurface& second);

}  // namespace exsect::cli
