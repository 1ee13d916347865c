// Two surfaces in boxes against what the boxes leave of the common points of the whole surfaces.
#pragma once

#include <exsect/solver/intersect_equations.h>

#include <string>

#include "tiny_boxes.h"

namespace exsect::box_oracle {

/// Empty if the complete answers agree as far as doubles tell: points of the whole answer that are certainly
/// in both boxes are near the one in boxes, which leaves none of the boxes, and their lengths are the same.
/// Otherwise what does not agree.
std::string difference(const tiny_boxes::Face& first, const tiny_boxes::Face& second,
                       const SurfaceIntersection& whole, const SurfaceIntersection& in_boxes);

}  // namespace exsect::box_oracle
