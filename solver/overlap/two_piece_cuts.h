// Where the self-intersection of the rectangle around two pieces of one surface is cut at their sides.
// Internal to solver/; docs/method.md, section 6.3.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "overlap/overlap_boundary.h"
#include "overlap/two_pieces.h"
#include "self/cuts.h"

namespace exsect {

/// From the parameters (u,v,r,s) of the pieces to those of their hull, both in [0,1]².
std::array<AffineMap, 4> maps_to_hull(const TwoPieces& pieces);

/// `cuts` in parameters of the hull; `points`: which points of the boundary they are.
struct TwoPieceCuts {
  std::vector<PairCut> cuts;
  std::vector<std::size_t> points;
};

/// The boundary points that are pairs of different points of the surface: all that are no ends of arcs on the
/// common surface, nor touch it. Empty if one cannot be told from a pair of equal points, or from another one
/// in the other order. The arguments must outlive the result.
std::optional<TwoPieceCuts> two_piece_cuts(const TwoPieces& pieces, const OverlapBoundary& boundary);

}  // namespace exsect
