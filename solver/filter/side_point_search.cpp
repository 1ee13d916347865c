#include "filter/side_point_search.h"

#include <algorithm>
#include <type_traits>

#include "filter/corner_ports.h"
#include "filter/line.h"
#include "filter/lone_corner.h"
#include "filter/side_corners.h"

namespace exsect::filter {

namespace {

constexpr std::size_t kMostSidePoints = 16;

/// By charts (14.26). Empty if nothing is proved; no ports if nothing but the sides ends in the corner.
template <class K>
std::optional<CentreOf<K>> centre_by_charts(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                            const PairOf<K>& pair, CornerContact& corner,
                                            const std::vector<SideAtCorner>& sides) {
  if (corner.is_pole()) return std::nullopt;
  const CornerNet of_x = corner_net<K>(x, corner.x, std::nullopt);
  const auto found = corner_branches(of_x, corner_net<K>(y, corner.y, std::nullopt), sides);
  auto centre = found ? branched_corner<K>(pair, corner, of_x, *found) : std::nullopt;
  if (centre) corner.lone_reach = to_double(found->reach);
  return centre;
}

/// The corners in which common sides end.
template <class K>
bool find_side_corners(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                       ContactsOf<K>& contacts, std::vector<CentreOf<K>>& centres) {
  bool found = false;
  for (auto& [corner, sides] : side_corners<K>(x, y, pair, contacts)) {
    const auto is_known = [&](const CornerContact& known) {
      return known.x == corner.x && known.y == corner.y;
    };
    if (std::ranges::any_of(contacts.branched, is_known)) continue;
    auto centre = centre_by_charts<K>(x, y, pair, corner, sides);
    if (!centre) continue;
    found = true;
    contacts.branched.push_back(corner);
    if (!centre->ports.empty()) centres.push_back(*std::move(centre));
  }
  return found;
}

}  // namespace

template <class K>
std::optional<Vec4> undecided_on_sides(const PairOf<K>& pair, TreesOf<K>& trees,
                                       const ContactsOf<K>& contacts) {
  for (std::size_t fixed = 0; fixed < 4; ++fixed) {
    for (const double side : {-0.5, 0.5}) {
      if (const auto at =
              undecided_on_line(pair, {fixed, side, 0}, contacts, fixed < 2 ? trees.y : trees.x)) {
        return at;
      }
    }
  }
  return std::nullopt;
}

template <class K>
bool add_side_point(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair, const Vec4& place,
                    ContactsOf<K>& contacts) {
  const auto point = side_point_near<K>(x, y, pair, place);
  const auto is_same = [&](const SidePointOf<K>& known) {
    return point->on == known.on && contains(known.tube, point->ball);
  };
  if (!point || contacts.points.size() == kMostSidePoints ||
      std::any_of(contacts.points.begin(), contacts.points.end(), is_same)) {
    return false;
  }
  std::erase_if(contacts.corners,
                [&](const CornerContact& corner) { return !corner.is_pole() && is_at(*point, corner); });
  contacts.points.push_back(*point);
  return true;
}

template <class K>
bool add_side_double_point([[maybe_unused]] const ExactPatch<K>& x, [[maybe_unused]] const ExactPatch<K>& y,
                           [[maybe_unused]] const PairOf<K>& pair, [[maybe_unused]] const Vec4& place,
                           [[maybe_unused]] double tolerance, [[maybe_unused]] ContactsOf<K>& contacts) {
  if constexpr (std::is_same_v<K, Biquadratic>) {
    return false;
  } else {
    auto point = double_point_near<K>(x, y, pair, place, tolerance);
    const auto is_same = [&](const DoublePointOf<K>& known) { return may_be_same(known, *point); };
    const auto has_ports = [&](const CornerContact& corner) { return place_of<K>(corner) == point->on; };
    if (!point || !is_on_side(*point) || contacts.double_points.size() == kMostSidePoints ||
        std::ranges::any_of(contacts.branched, has_ports) ||
        std::any_of(contacts.double_points.begin(), contacts.double_points.end(), is_same)) {
      return false;
    }
    std::erase_if(contacts.corners, [&](const CornerContact& corner) {
      return point->forms.crossing && !corner.is_pole() && place_of<K>(corner) == point->on;
    });
    contacts.double_points.push_back(*std::move(point));
    return true;
  }
}

template <class K>
bool add_corner_points(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                       ContactsOf<K>& contacts) {
  bool added = false;
  for (const CornerContact& corner : std::vector(contacts.corners)) {
    added = (!corner.is_pole() && add_side_point(x, y, pair, place_of<K>(corner), contacts)) || added;
  }
  return added;
}

template <class K>
bool find_corners([[maybe_unused]] const ExactPatch<K>& x, [[maybe_unused]] const ExactPatch<K>& y,
                  [[maybe_unused]] const PairOf<K>& pair, [[maybe_unused]] ContactsOf<K>& contacts,
                  [[maybe_unused]] std::vector<CentreOf<K>>& centres) {
  bool found = false;
  if constexpr (!std::is_same_v<K, Biquadratic>) {  // exact arithmetic is behind these
    std::vector<CornerContact> corners;
    for (CornerContact corner : contacts.corners) {
      const bool is_known = corner.lone_reach > 0;
      if (!is_known) corner.lone_reach = lone_reach<K>(x, y, corner);
      auto centre = corner.lone_reach > 0 ? std::nullopt : centre_by_charts<K>(x, y, pair, corner, {});
      found = found || (!is_known && corner.lone_reach > 0);
      const bool is_branched = centre && !centre->ports.empty();
      (is_branched ? contacts.branched : corners).push_back(corner);
      if (is_branched) centres.push_back(*std::move(centre));
    }
    contacts.corners = std::move(corners);
    found = find_side_corners(x, y, pair, contacts, centres) || found;
  }
  return found;
}

#define EXSECT_INSTANTIATE(K)                                                                                \
  template std::optional<Vec4> undecided_on_sides<K>(const PairOf<K>&, TreesOf<K>&, const ContactsOf<K>&);   \
  template bool add_side_point<K>(const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&, const Vec4&, \
                                  ContactsOf<K>&);                                                           \
  template bool add_side_double_point<K>(const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&,       \
                                         const Vec4&, double, ContactsOf<K>&);                               \
  template bool add_corner_points<K>(const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&,           \
                                     ContactsOf<K>&);                                                        \
  template bool find_corners<K>(const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&,                \
                                ContactsOf<K>&, std::vector<CentreOf<K>>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
