// The points of the intersection that the tracer cannot pass: singular points, tangential boundary points,
// points where a patch is singular.
// Internal to solver/.
#pragma once

#include <vector>

#include "star/star_neighbourhood.h"
#include "trace/pair_system.h"

namespace exsect {

/// What is known of a pair before its singular points are looked for.
struct SingularPointQuery {
  ExactPair& pair;
  StarPlaces places;
  const std::vector<bool>& on_side_arc;        // which boundary points are ends of arcs that lie on sides
  const std::vector<CertifiedPoint>& pinches;  // pinch_points(x, y)
  double tolerance;                            // of polylines, patches scaled to unit size
};

/// Disjoint stars around the multiple points over multiple rational turning values of all four sweeps that
/// may be singular, around the boundary points where the tangent may lie in a side, and around pinch points.
/// Points for which no star can be proved are left out; the tracer then fails there.
/// After ExactPair::stop() the stars found so far are all.
template <class Ball>
std::vector<StarNeighbourhood> singular_stars(const SingularPointQuery& query,
                                              const PairSystem<Ball>& system);

}  // namespace exsect
