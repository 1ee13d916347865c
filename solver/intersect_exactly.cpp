#include "intersect_exactly.h"

#include "intersect_divided.h"
#include "intersect_unfolded.h"
#include "overlap/overlaps.h"
#include "special/common_apex.h"
#include "special/degenerate_patches.h"
#include "special/intersect_in_pole.h"
#include "special/missed_plane.h"
#include "sweep/intersect_by_sweep.h"

namespace exsect {

IntersectResult intersect_exactly(const BezierPatch& x, const BezierPatch& y, const Run& run) {
  ExactPair pair(x, y, run.stop());
  return intersect_exactly(x, y, run, pair);
}

IntersectResult intersect_exactly(const BezierPatch& x, const BezierPatch& y, const Run& run,
                                  ExactPair& pair) {
  if (std::optional<IntersectResult> result = intersect_degenerate(x, y, run)) {
    return std::move(*result);
  }
  for (const auto& method : {intersect_missed_plane, intersect_in_pole, intersect_cones}) {
    if (std::optional<IntersectResult> result = method(x, y)) {
      return std::move(*result);
    }
  }
  for (const auto& method : {intersect_divided, intersect_unfolded, intersect_on_one_surface}) {
    if (std::optional<IntersectResult> result = method(x, y, run)) {
      return std::move(*result);
    }
  }
  return intersect_by_sweep(x, y, run, pair);
}

}  // namespace exsect
