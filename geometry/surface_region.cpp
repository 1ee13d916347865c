#include "surface_region.h"

#include <algorithm>

namespace exsect {

bool SurfaceRegion::contains(const Point& p) const {
  return std::ranges::all_of(clauses, [&](const std::vector<std::size_t>& clause) {
    return std::ranges::any_of(clause, [&](std::size_t bound) { return bounds[bound].form(p) >= 0; });
  });
}

}  // namespace exsect
