// Random surfaces given by their equations with small integers, where special positions are common.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <string>

#include "support/random_pairs.h"

namespace exsect::tiny_surfaces {

/// Integers from -size to size.
Point vector_of(random_pairs::Generator& generator, long size);
/// A plane, cylinder, cone, sphere or torus with points and axes in {-1..1}, every second axis (0,0,1) at
/// least, and radii 1 to 3.
ImplicitSurface tiny_surface(random_pairs::Generator& generator);
/// The polynomial alone: of a cone both nappes.
ImplicitSurface unnamed(const ImplicitSurface& surface);
/// Kind, point, axis, and squares of the radii.
std::string written(const ImplicitSurface& surface);

}  // namespace exsect::tiny_surfaces
