#include "filter/side_corners.h"

#include <algorithm>

#include "filter/common_side.h"

namespace exsect::filter {

namespace {

/// Corners of both patches at the ends of the side, or of the part of it that both have.
template <class K>
std::vector<CornerContact> corners_at_ends(const SideContactOf<K>& side) {
  if (!side.path) return side.ends;
  std::vector<CornerContact> result;
  for (const auto& at : ends_of_part<K>(side, *side.path)) {
    const auto on_x = corner_of<K>(at[0], at[1]), on_y = corner_of<K>(at[2], at[3]);
    if (on_x && on_y) result.push_back({*on_x, *on_y});
  }
  return result;
}

}  // namespace

template <class K>
std::vector<SideCorner> side_corners(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                                     const ContactsOf<K>& contacts) {
  std::vector<SideCorner> result;
  for (const SideContactOf<K>& side : contacts.sides) {
    const SideAtCorner here = {{side.x.side.parameter, 2 + side.y.side.parameter},
                               contact_along<K>(x, y, pair, side) == Contact::tangential};
    for (const CornerContact& corner : corners_at_ends<K>(side)) {
      if (corner.is_pole()) continue;
      const auto known = std::ranges::find_if(result, [&](const SideCorner& other) {
        return other.corner.x == corner.x && other.corner.y == corner.y;
      });
      if (known == result.end())
        result.push_back({corner, {here}});
      else
        known->sides.push_back(here);
    }
  }
  return result;
}

#define EXSECT_INSTANTIATE(K)                                                                  \
  template std::vector<SideCorner> side_corners<K>(const ExactPatch<K>&, const ExactPatch<K>&, \
                                                   const PairOf<K>&, const ContactsOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
