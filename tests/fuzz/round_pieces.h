// Random pieces of round surfaces as patches with weights, as models hold them, in special positions.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <utility>

#include "support/random_pairs.h"

namespace exsect::round_pieces {

/// A rectangle, a quarter of a cylinder or of a truncated cone, an octant of a sphere, a zone of it without
/// its pole, or a quarter of a torus' inner or outer, upper or lower half, about the origin. Sizes are small
/// integers and halves. Three of four are turned by right angles, others by a small quaternion.
RationalPatch round_piece(random_pairs::Generator& generator);
/// Most are moved so that a point with parameters in {0, 1/3, 1/2, 1} is a point of both, exactly, to the
/// next quarter, or but for 1e-1 to 1e-8.
std::pair<RationalPatch, RationalPatch> round_pair(random_pairs::Generator& generator);
/// Large pieces of radii 1 to 3, cones with their apices among them, with axes parallel to those of space and
/// whole coordinates of -1, 0 and 1 for their centres: as people place them, with curves in poles, along
/// sides, meridians and rulings.
std::pair<RationalPatch, RationalPatch> placed_pair(random_pairs::Generator& generator);

}  // namespace exsect::round_pieces
