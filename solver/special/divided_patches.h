// Pairs of which a patch has a parameter line inside its square that is one point of the other patch.
// Internal to solver/; docs/method.md, section 6.8.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include <optional>
#include <vector>

#include "answer/run.h"

namespace exsect {

/// The patches over a box of the parameters, each reparametrised affinely to [0,1]^2.
struct PairOfPieces {
  BezierPatch x;
  BezierPatch y;
  ParameterBox over;
};

/// Pieces that cover x and y, divided along all parameter lines inside the squares that are one point of
/// space, which the other patch contains: such lines are sides of pieces. Empty if there are none, or if they
/// cross, or are not rational.
std::optional<std::vector<PairOfPieces>> divided_pair(const BezierPatch& x, const BezierPatch& y);

/// The intersection of x and y from those of divided_pair(x, y), in order: the nodes that stand for a line
/// of division, one in each piece at the line, become one. Empty where patches overlap.
std::optional<IntersectResult> joined(const std::vector<PairOfPieces>& pieces,
                                      std::vector<IntersectResult> of_pieces, const BezierPatch& x,
                                      const BezierPatch& y, const Run& run);

}  // namespace exsect
