// Pairs of which a patch depends on one of its parameters through a square alone. Internal to solver/;
// docs/method.md, section 6.7.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/result.h>

#include <optional>
#include <vector>

#include "answer/run.h"
#include "shape/monotone_quadratic.h"

namespace exsect {

/// The parameter is the preimage of the one of the other pair, after reversal if `reversed`.
struct Unfolding {
  Parameter parameter;
  MonotoneQuadratic square;
  bool reversed;

  /// The side along which the patch is singular.
  std::optional<Side> turned_side() const {
    if (square.starts_at_turn()) return Side{parameter, reversed ? 1 : 0};
    return std::nullopt;
  }
};

struct UnfoldedPair {
  BezierPatch x;
  BezierPatch y;
  std::vector<Unfolding> unfoldings;
};

/// The pair in terms of the squares, if each parameter that a patch depends on through a square alone runs
/// through it once, and there is one: its solutions are in bijection with those of x and y. Empty otherwise.
std::optional<UnfoldedPair> unfolded_pair(const BezierPatch& x, const BezierPatch& y);

/// The intersection of x and y from that of unfolded_pair(x, y), its parameters replaced by their preimages.
IntersectResult folded_back(const UnfoldedPair& pair, IntersectResult of_squares, const BezierPatch& x,
                            const BezierPatch& y, const Run& run);

}  // namespace exsect
