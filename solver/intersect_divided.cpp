#include "intersect_divided.h"

#include <vector>

#include "intersect_within.h"
#include "special/divided_patches.h"

namespace exsect {

std::optional<IntersectResult> intersect_divided(const BezierPatch& x, const BezierPatch& y, const Run& run) {
  const auto pieces = divided_pair(x, y);
  if (!pieces) return std::nullopt;
  std::vector<IntersectResult> results;
  results.reserve(pieces->size());
  for (const PairOfPieces& pair : *pieces) results.push_back(intersect_within(run, pair.x, pair.y));
  return joined(*pieces, std::move(results), x, y, run);
}

}  // namespace exsect
