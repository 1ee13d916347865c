// The intersection of two surfaces given by their equations as a picture.
#pragma once

#include <string>

#include "output/drawing/surfaces_scene.h"

namespace exsect::cli {

/// The scene in parallel projection, seen from (2,-3,2) with z upwards: both surfaces as wires, a colour for
/// each curve, touching ones dashed, and the nodes that the curves have. Throws BeyondDoubles.
std::string surfaces_svg(const DrawnSurfaces& drawn, const std::string& title);

}  // namespace exsect::cli
