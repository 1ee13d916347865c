// Speed and curvature of the arcs of tubes in space. Internal to solver/; docs/method-doubles.md,
// section 14.6.
#pragma once

#include "filter/tube.h"

namespace exsect::filter {

/// Bounds on a tube, in scaled space: |X(w) - X(w~)| <= speed |w - w~| for the space point X = x(u,v), and
/// |X''| <= curvature along the arc.
struct SpaceBounds {
  double speed;
  double curvature;
  double least_weight = 1;
};
/// Both are infinite where the weight is not proved positive.
template <class K>
SpaceBounds space_bounds(const PairOf<K>& pair, const TubeOf<K>& tube);

}  // namespace exsect::filter
