#include "lift/pair_region.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace exsect {
namespace {

void append(SurfaceRegion& all, const SurfaceRegion& further) {
  const std::size_t shift = all.bounds.size();
  all.bounds.insert(all.bounds.end(), further.bounds.begin(), further.bounds.end());
  for (std::vector<std::size_t> clause : further.clauses) {
    for (std::size_t& bound : clause) bound += shift;
    all.clauses.push_back(std::move(clause));
  }
}

}  // namespace

PairRegion pair_region(const ImplicitSurface& first, const ImplicitSurface& second) {
  PairRegion result{first.region(), 0};
  result.of_first = result.all.bounds.size();
  append(result.all, second.region());
  return result;
}

PairRegion within(PairRegion region, const SurfaceRegion& further) {
  const std::size_t known = region.all.bounds.size();
  append(region.all, further);
  for (std::size_t i = known; i < region.all.bounds.size(); ++i) region.all.bounds[i].name.clear();
  return region;
}

bool are_equal(const SurfaceRegion& a, const SurfaceRegion& b) {
  return a.clauses == b.clauses &&
         std::ranges::equal(a.bounds, b.bounds, {}, &SurfaceBound::form, &SurfaceBound::form);
}

std::optional<RationalInterval> part_of_line(const PairRegion& region, const Point& point,
                                             const Point& along) {
  if (region.all.clauses.empty()) return RationalInterval{-1, 1};
  std::optional<Rational> lower, upper;
  for (const std::vector<std::size_t>& clause : region.all.clauses) {
    const SpacePolynomial& form = region.all.bounds[clause.front()].form;
    const Rational value = form(point), rate = form(point + along) - value;
    if (rate == 0 && value < 0) return std::nullopt;
    if (rate == 0) continue;
    const Rational at = -value / rate;
    std::optional<Rational>& end = rate > 0 ? lower : upper;
    if (!end || (rate > 0 ? *end < at : at < *end)) end = at;
  }
  if (!lower || !upper) throw std::logic_error("part_of_line: the region does not bound the line");
  return *lower <= *upper ? std::optional(RationalInterval{*lower, *upper}) : std::nullopt;
}

std::vector<std::size_t> bounds_at(const PairRegion& region, const Point& point) {
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < region.all.bounds.size(); ++i) {
    const SurfaceBound& bound = region.all.bounds[i];
    if (!bound.name.empty() && bound.form(point) == 0 && bound.where(point) >= 0) positions.push_back(i);
  }
  return positions;
}

std::array<std::vector<std::string>, 2> names_of(const PairRegion& region,
                                                 const std::vector<std::size_t>& bounds) {
  std::array<std::vector<std::string>, 2> names;
  for (const std::size_t bound : bounds) {
    const std::string& name = region.all.bounds[bound].name;
    std::vector<std::string>& of = names[bound < region.of_first ? 0 : 1];
    if (!name.empty() && std::ranges::find(of, name) == of.end()) of.push_back(name);
  }
  return names;
}

}  // namespace exsect
