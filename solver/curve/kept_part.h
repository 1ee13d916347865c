// The part of a plane curve's graph in a region. Internal to solver/; docs/method-equations.md, section 17.8.
#pragma once

#include <exsect/solver/curve_graph.h>

namespace exsect {

/// The arcs in the region, closed, and the nodes of these, and in it. Requires that the points on the rim are
/// nodes with `exact`, but for those of arcs on which a bound vanishes: then an arc is in the region, or has
/// no inner point there (Lemma 17.7), and a node that is not exact lies where its arcs do.
CurveGraph kept_part(CurveGraph graph, const PlacedRegion& region);

}  // namespace exsect
