#include "lift/crossing_bounds.h"

#include <algorithm>
#include <utility>

namespace exsect {

std::vector<CrossingBound> crossing_bounds(const CrossingBranches& branches, const SurfaceRegion& region) {
  const SpaceProjection& projection = branches.projection;
  std::vector<CrossingBound> bounds;
  for (const SurfaceBound& bound : region.bounds) {
    std::vector<Polynomial> norms;
    for (const CrossingBranch& branch : branches.all)
      norms.push_back(norm_over(projection, branch.shadow, bound.form).value());
    bounds.push_back({bound.form, bound.where, sign_below(projection, bound.form),
                      sign_below(projection, bound.where), std::move(norms)});
  }
  return bounds;
}

bool is_in_region(const SurfaceRegion& region, const std::vector<int>& signs) {
  return std::ranges::all_of(region.clauses, [&](const std::vector<std::size_t>& clause) {
    return std::ranges::any_of(clause, [&](std::size_t bound) { return signs[bound] >= 0; });
  });
}

}  // namespace exsect
