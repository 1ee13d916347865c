// The intersection of two surfaces given by their equations as a picture.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "output/drawing/surfaces_scene.h"
#include "output/drawing/svg_picture.h"

namespace exsect::cli {

/// The scene in parallel projection, seen from (2,-3,2) with z upwards: both surfaces as wires, a colour for
/// each curve, touching ones dashed, and the nodes that the curves have. Throws BeyondDoubles.
std::string surfaces_svg(const DrawnSurfaces& drawn, const std::string& title);

/// What is drawn besides, below the curves or above everything; and its legend.
struct SpaceAdditions {
  std::vector<std::pair<SpacePoints, Stroke>> below = {};
  std::vector<std::pair<SpacePoints, Stroke>> above = {};
  SpacePoints marks = {};  // red crosses
  std::vector<std::pair<Stroke, std::string>> legend = {};
};
std::string surfaces_svg(const DrawnSurfaces& drawn, const std::string& title,
                         const SpaceAdditions& additions);

}  // namespace exsect::cli
