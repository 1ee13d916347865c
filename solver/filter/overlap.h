// Pieces of one surface that overlap, in doubles. Internal to solver/; docs/method-doubles.md, sections 14.10
// and 14.15.
#pragma once

#include "answer/graph_builder.h"
#include "filter/pieces.h"
#include "shape/shifted_copy.h"

namespace exsect::filter {

/// y is x in other parameters: (u,v) = (maps[0](r), maps[1](s)), or (maps[0](s), maps[1](r)) if exchanged,
/// and their squares have a rectangle in common, with inner points: an overlap.
struct OverlapOfPieces {
  std::array<AffineMap, 2> maps;
  bool exchanged;

  std::size_t parameter(std::size_t of_x) const { return exchanged ? 1 - of_x : of_x; }
};

/// The rectangle is the whole intersection if the surface is injective on both squares together. Empty if y
/// is no such piece, none that is found, or if they share no rectangle.
template <class K>
std::optional<OverlapOfPieces> pieces_of_one_surface(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                     const PairOf<K>& pair);

/// The same, empty if it is not proved that the surface is injective on both squares together as well.
/// `boxes` counts the pairs looked at.
template <class K>
std::optional<OverlapOfPieces> overlap_of_pieces(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                 const PairOf<K>& pair, TreesOf<K>& trees, long& boxes);

/// What neighbours on one surface share: a whole side of both, or a corner.
enum class Common { side, corner };
/// True only if the patches are pieces of one surface that is injective on both squares together, and have
/// that in common and nothing else. `boxes` counts the pairs looked at.
template <class K>
bool meet_as_neighbours(Common common, const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                        TreesOf<K>& trees, long& boxes);

/// The graph of the overlap. Empty if a polyline cannot keep within `accepted`; it keeps within `tolerance`
/// (space units, both) if it can.
std::optional<GraphBuilder> overlap_graph(const RationalPatch& x, const OverlapOfPieces& overlap,
                                          double tolerance, double accepted);

}  // namespace exsect::filter
