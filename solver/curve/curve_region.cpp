#include "curve/curve_region.h"

#include <algorithm>

namespace exsect {

RegionPlace place_by_signs(const std::vector<std::vector<std::size_t>>& clauses,
                           const std::function<int(std::size_t)>& sign_of_bound) {
  RegionPlace place = RegionPlace::inside;
  for (const std::vector<std::size_t>& clause : clauses) {
    int best = -1;
    for (const std::size_t bound : clause) best = best > 0 ? best : std::max(best, sign_of_bound(bound));
    if (best < 0) return RegionPlace::outside;
    if (best == 0) place = RegionPlace::rim;
  }
  return place;
}

PlacedRegion::PlacedRegion(const CurveRegion& region) : clauses_(region.clauses), marked_(region.marked) {
  for (const BivariatePolynomial& bound : region.bounds) bounds_.push_back(bound.exchanged());
}

RegionPlace PlacedRegion::place_of(const TriangularPoint& point) const {
  const auto sign_of_bound = [&](std::size_t i) { return sign_at(bounds_[i], point); };
  const RegionPlace place = place_by_signs(clauses_, sign_of_bound);
  const bool is_marked = place == RegionPlace::inside &&
                         std::ranges::any_of(marked_, [&](std::size_t i) { return sign_of_bound(i) == 0; });
  return is_marked ? RegionPlace::rim : place;
}

}  // namespace exsect
