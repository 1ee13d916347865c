// Surfaces given by their equations as meshes, for the eye.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "output/drawing/scene.h"

namespace exsect::cli {

using SpacePoints = std::vector<std::array<double, 3>>;

/// The corners of a box around a sphere or torus; none of other surfaces, which are unbounded or not known to
/// be bounded. Throws BeyondDoubles.
SpacePoints extreme_points(const ImplicitSurface& surface);

/// The surface on a grid of cells x cells: a sphere or torus as a whole, a plane, cylinder or cone as far as
/// `around` lies beside it, and somewhat farther. Empty for a polynomial, and for an unbounded surface where
/// `around` is empty. Nothing is proved of it. Throws BeyondDoubles.
std::optional<SceneMesh> sampled(const ImplicitSurface& surface, const std::string& name,
                                 const SpacePoints& around, int cells);

}  // namespace exsect::cli
