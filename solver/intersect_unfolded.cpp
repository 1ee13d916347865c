#include "intersect_unfolded.h"

#include "intersect_within.h"
#include "special/unfolded_parameters.h"

namespace exsect {

std::optional<IntersectResult> intersect_unfolded(const BezierPatch& x, const BezierPatch& y,
                                                  const Run& run) {
  const std::optional<UnfoldedPair> pair = unfolded_pair(x, y);
  if (!pair) return std::nullopt;
  return folded_back(*pair, intersect_within(run, pair->x, pair->y), x, y, run);
}

}  // namespace exsect
