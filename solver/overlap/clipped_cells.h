// The curves of two pieces of one surface of any kind, out of those of the rectangle around both in cells.
// Internal to solver/; docs/method-doubles.md, section 14.15.
#pragma once

#include "filter/overlap.h"
#include "overlap/pair_map.h"
#include "self/glued_cells.h"

namespace exsect {

/// Two pieces of a surface x, and the smallest rectangle of x's parameters around both squares, their hull.
struct PiecesInHull {
  explicit PiecesInHull(const filter::OverlapOfPieces& overlap);

  /// The sides of both squares inside of the hull, in its parameters in [0,1]².
  ParameterLines sides() const;
  /// The first cell in x's square, the second one in y's: cells that have none of these sides inside.
  bool contain(const std::array<ParameterRectangle, 2>& cells) const;

  filter::OverlapOfPieces pieces;
  std::array<AffineMap, 2> around;   // from [0,1]² to the hull
  std::array<AffineMap, 4> to_hull;  // from the squares of x, and of y but for the names of its parameters
};

/// Appends all pairs of different parameters of the hull at which the surface has one value, in both orders,
/// of which the first point is in x's square and the second one in y's. `graph` has the overlap. Arcs may end
/// in nodes of kind turning with respect to no parameter. False if a cuspidal point on a side is not found on
/// the overlap's rim.
bool append_clipped_cells(GraphBuilder& graph, const GluedCells& cells, const PiecesInHull& pieces);

}  // namespace exsect
