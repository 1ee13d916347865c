#include "answer/coarse_drawing.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect {

std::optional<CoarseDrawing> coarse_drawing(const IntersectionGraph& graph, double tolerance) {
  double bound = 0;
  const auto cover = [&](const std::vector<Arc>& arcs) {
    for (const Arc& arc : arcs) bound = larger_bound(bound, arc.error_bound);
  };
  cover(graph.arcs);
  for (const Overlap& overlap : graph.overlaps) std::ranges::for_each(overlap.chains, cover);
  if (bound <= tolerance && std::isfinite(bound)) return std::nullopt;
  return CoarseDrawing{tolerance, bound};
}

}  // namespace exsect
