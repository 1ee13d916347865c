#include "filter/contact_regions.h"

#include "filter/boundary.h"
#include "filter/contact_finder.h"

namespace exsect {

ContactRegions::ContactRegions(const BezierPatch& x, const BezierPatch& y) : pair_(filter::make_pair(x, y)) {
  auto contacts = pair_ ? filter::find_contacts(x, y, *pair_) : std::nullopt;
  if (!contacts) return;
  filter::Trees trees{filter::PatchTree(pair_->x), filter::PatchTree(pair_->y)};
  filter::add_side_paths<filter::Biquadratic>(x, y, *pair_, trees, *contacts);
  contacts_ = std::move(*contacts);
  contacts_.corners.clear();
}

bool ContactRegions::settles(const SearchRegion& region) const {
  if (contacts_.empty()) return false;
  const auto part = [&](std::size_t first) {
    filter::Part result{};
    for (std::size_t i = 0; i < 2; ++i) result.range[i] = {region.lower[first + i], region.upper[first + i]};
    return result;
  };
  return filter::meeting(*pair_, contacts_, part(0), part(2)) == filter::Meeting::contact;
}

}  // namespace exsect
