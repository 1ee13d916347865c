// How far a chain is from others. Internal to solver/; docs/method-verify.md, section 15.
#pragma once

#include <exsect/algebra/interruption.h>
#include <exsect/verify/verdict.h>

#include "answer/stop_request.h"
#include "interval_lists.h"
#include "piece_tree.h"

namespace exsect {

/// Throws Interrupted if the time for a verdict is over.
inline void require_time(const StopRequest& stop) {
  if (is_stopped(stop)) throw Interrupted();
}

/// The part of a piece, in [0,1], whose points are all farther than a distance from a set of curves.
class FarParts {
 public:
  FarParts(const PieceTree& others, double least, double smallest)
      : others_(others), least_(least), smallest_(smallest) {}

  /// In the parameter from..to of the segment from a to b; `slack` is added to the distance asked for. Parts
  /// shorter than it, or than `smallest`, are not told apart.
  void find(const SpacePoint& a, const SpacePoint& b, double from, double to, double slack);
  std::vector<Interval> parts() const { return united(parts_); }

 private:
  const PieceTree& others_;
  double least_;
  double smallest_;
  std::vector<Interval> parts_;
};

/// Bounds of the largest distance of a point of the chain from the nearest of the others; where it is below
/// `fine` the upper one need not be sharp. Infinite if there are no others. Throws Interrupted.
DistanceEnclosure largest_distance(const Chain& chain, const PieceTree& others, double fine,
                                   const StopRequest& stop = {});

}  // namespace exsect
