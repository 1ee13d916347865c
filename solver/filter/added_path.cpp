#include "filter/added_path.h"

#include <algorithm>
#include <type_traits>

#include "answer/rim_arc.h"
#include "filter/contact_finder.h"

namespace exsect::filter {

namespace {

/// The sides of both patches that the path runs along; empty if it is inside of one.
std::optional<std::array<SquareSide, 2>> common_sides(const SidePath& path) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Rational& value = path.ends[0][i];
    if (value == path.ends[1][i] && (value == 0 || value == 1)) {
      const SquareSide other = {i, value == 1};
      return path.of_x ? std::array{path.side, other} : std::array{other, path.side};
    }
  }
  return std::nullopt;
}

/// An arc of contact ends there.
template <class K>
void erase_corners(const std::array<Rational, 4>& at, ContactsOf<K>& contacts) {
  std::erase_if(contacts.corners, [&](const CornerContact& corner) {
    return corner_of<K>(at[0], at[1]) == corner.x && corner_of<K>(at[2], at[3]) == corner.y;
  });
}

/// Both are on the same line, if they have a point in common.
bool is_on(const LinePath& known, const std::array<Rational, 4>& at) {
  const Rational& t = at[(known.of_x ? 0 : 2) + 1 - known.parameter];
  return known.at(t) == at;
}

/// From y's parameter to x's, as the views count: along the line from + (to - from) f is that of x at t' of
/// y, or that of y at t of x, solved for t. Weights are positive on the part that both have in common.
MoebiusMap<Rational> to_x(const SidePath& path, const Rational& from, const Rational& to) {
  MoebiusMap<Rational> map = {{from, to * path.ratio}, {1, path.ratio}};
  if (path.of_x) {
    const int sign = from < to ? 1 : -1;
    map = {{-sign * from, sign * (1 - from)},
           {sign * (path.ratio * to - from), sign * (path.ratio * (to - 1) + 1 - from)}};
  }
  if (to < from) {
    std::swap(map.value[0], map.value[1]);
    std::swap(map.weight[0], map.weight[1]);
  }
  return map;
}

template <class K>
SideContactOf<K> part_of_side(const SidePath& path, const std::array<SquareSide, 2>& sides,
                              const PairOf<K>& pair) {
  const std::size_t along = 1 - sides[path.of_x ? 1 : 0].parameter;
  const Rational& from = path.ends[0][along];
  const Rational& to = path.ends[1][along];
  const bool reversed = to < from;
  const SideView x = {sides[0], false, K::degree};
  const SideView y = {sides[1], reversed, K::degree};
  if constexpr (K::weighted) {
    SideContactOf<K> contact = weighted_side_contact<K>(pair, x, y, to_x(path, from, to));
    contact.path = path;
    return contact;
  } else {
    SideContactOf<K> contact = side_contact<K>(pair, x, y);
    contact.path = path;
    const Rational length = abs(to - from);
    // Along the line the parameter is from + (to - from) t; t of x and t' of y, 1 - t' if reversed.
    contact.factor = to_double(path.of_x ? 1 / length : length);
    contact.offset =
        path.of_x ? to_double(-(reversed ? 1 - from : from) / length) : to_double(reversed ? to : from);
    return contact;
  }
}

}  // namespace

template <class K>
void add_path(const SidePath& path, const PairOf<K>& pair, ContactsOf<K>& contacts) {
  if (const auto sides = common_sides(path)) {
    const auto is_same = [&](const SideContactOf<K>& known) {
      return known.x.side == (*sides)[0] && known.y.side == (*sides)[1];
    };
    if (std::none_of(contacts.sides.begin(), contacts.sides.end(), is_same)) {
      contacts.sides.push_back(part_of_side<K>(path, *sides, pair));
    }
  } else if constexpr (std::is_same_v<K, Biquadratic>) {
    const auto is_same = [&](const PathContact& known) {
      return known.path.of_x == path.of_x && known.path.side == path.side && known.path.ends == path.ends;
    };
    if (std::none_of(contacts.paths.begin(), contacts.paths.end(), is_same)) {
      contacts.paths.push_back(path_contact(path, pair));
    }
  } else {
    return;
  }
  for (const Rational& t : {path.common.lower, path.common.upper}) {
    erase_corners<K>(path.at(t), contacts);
  }
}

template <class K>
bool add_contact_line(const ContactLineOf<K>& line, ContactsOf<K>& contacts) {
  const LinePath& path = line.path;
  const auto at_middle = path.at(path.common.midpoint());
  const Node middle = rim_node(at_middle);
  const auto is_side_of = [&](std::size_t patch) {
    return std::ranges::any_of(middle.on,
                               [&](const Side& side) { return index(side.parameter) / 2 == patch; });
  };
  if ((is_side_of(0) && is_side_of(1)) ||
      std::ranges::any_of(contacts.lines,
                          [&](const ContactLineOf<K>& known) { return is_on(known.path, at_middle); }))
    return false;
  contacts.lines.push_back(line);
  for (const Rational& t : {path.common.lower, path.common.upper}) erase_corners<K>(path.at(t), contacts);
  return true;
}

#define EXSECT_INSTANTIATE(K) template bool add_contact_line<K>(const ContactLineOf<K>&, ContactsOf<K>&);
EXSECT_FILTER_OTHER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE
#define EXSECT_INSTANTIATE(K) template void add_path<K>(const SidePath&, const PairOf<K>&, ContactsOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
