// The nodes of stars in the graph of a self-intersection, and what their ports lead to. Internal to solver/.
#pragma once

#include "self/curves.h"

namespace exsect {

/// What every landmark of `found` leads to; the landmarks are nodes 0..n-1 of the graph. Appends the nodes of
/// stars whose centres are not among them, two unless the centre is a cuspidal point: the pair in both
/// orders. Isolated centres are listed as such.
template <class Ball>
std::vector<TraceEnd> ends_at_stars(GraphBuilder& graph, const BezierPatch& x, const SelfSystem<Ball>& system,
                                    const ExactPlaces& exact, const SelfCurves<Ball>& found,
                                    const ModelFrame& frame);

}  // namespace exsect
