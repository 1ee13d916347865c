#include "filter/boundary.h"

#include "filter/added_path.h"
#include "filter/line.h"

namespace exsect::filter {

template <class K>
std::optional<std::vector<BoundaryPointOf<K>>> boundary_points(const PairOf<K>& pair,
                                                               const ContactsOf<K>& contacts,
                                                               TreesOf<K>& trees, long& boxes) {
  std::vector<BoundaryPointOf<K>> points;
  for (std::size_t fixed = 0; fixed < 4; ++fixed) {
    for (const double side : {-0.5, 0.5}) {
      const auto on_side =
          points_on_line<K>(pair, {fixed, side, 0}, contacts, fixed < 2 ? trees.y : trees.x, boxes);
      if (!on_side) {
        return std::nullopt;
      }
      for (const BallOf<K>& ball : *on_side) {
        points.push_back({ball, fixed, side});
      }
    }
  }
  for (std::size_t i = 0; i < contacts.points.size(); ++i) {
    const SidePointOf<K>& point = contacts.points[i];
    BoundaryPointOf<K> end{point.ball, point.leaving, point.on[point.leaving]};
    end.on = point.on;
    end.isolated = !point.enters;
    end.side_point = static_cast<int>(i);
    points.push_back(end);
  }
  return points;
}

template <class K>
bool add_side_paths(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair, TreesOf<K>& trees,
                    ContactsOf<K>& contacts) {
  const ContactsOf<K> known = contacts;
  for (std::size_t fixed = 0; fixed < 4; ++fixed) {
    for (const double side : {-0.5, 0.5}) {
      const auto near = undecided_on_line(pair, {fixed, side, 0}, known, fixed < 2 ? trees.y : trees.x);
      const auto path = near ? side_path_near<K>(x, y, pair, fixed, side > 0, *near) : std::nullopt;
      if (path) {
        add_path<K>(*path, pair, contacts);
      }
    }
  }
  return contacts.sides.size() + contacts.paths.size() > known.sides.size() + known.paths.size();
}

#define EXSECT_INSTANTIATE(K)                                                 \
  template std::optional<std::vector<BoundaryPointOf<K>>> boundary_points<K>( \
      const PairOf<K>&, const ContactsOf<K>&, TreesOf<K>&, long&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE
#define EXSECT_INSTANTIATE(K)                                                                                \
  template bool add_side_paths<K>(const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&, TreesOf<K>&, \
                                  ContactsOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
