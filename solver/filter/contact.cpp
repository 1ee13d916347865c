#include "filter/contact.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace exsect::filter {

namespace {

constexpr long kMostBoxes = 600;
constexpr int kDeepest = 24;  // levels of both patches together
constexpr int kMostDirections = 12;

template <class K>
constexpr std::array<std::size_t, 4> kCorners = {0, K::degree, K::degree* K::side, K::count - 1};
constexpr std::array<SquareSide, 4> kSides = {{{0, false}, {0, true}, {1, false}, {1, true}}};

template <class K>
SideContactOf<K> side_contact(const PairOf<K>& pair, const SideView& x, const SideView& y) {
  SideContactOf<K> contact{x, y, {}, across_field<K>(pair.x.net, x), across_field<K>(pair.y.net, y)};
  for (std::size_t j = 0; j < K::degree; ++j) {
    contact.direction[j] = pair.x.net[x.index(0, j + 1)] - pair.x.net[x.index(0, j)];
  }
  return contact;
}

/// The index in the net of the corner with these parameters; empty if it is none.
std::optional<std::size_t> corner_of(const Rational& first, const Rational& second) {
  const auto is_end = [](const Rational& t) { return t == 0 || t == 1; };
  if (!is_end(first) || !is_end(second)) {
    return std::nullopt;
  }
  return (first == 1 ? 6U : 0U) + (second == 1 ? 2U : 0U);
}

template <class K>
class ContactFinder {
 public:
  ContactFinder(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair)
      : x_(x), y_(y), pair_(pair) {}

  std::optional<ContactsOf<K>> run() {
    if (!find_corners()) {
      return std::nullopt;
    }
    ContactsOf<K> contacts;
    std::vector<bool> on_side(corners_.size(), false);
    for (const SquareSide& a : kSides) {
      for (const SquareSide& b : kSides) {
        for (const bool reversed : {false, true}) {
          const SideView x = {a, false, K::degree};
          const SideView y = {b, reversed, K::degree};
          if (same_side(x, y)) {
            contacts.sides.push_back(side_contact<K>(pair_, x, y));
            for (std::size_t k = 0; k < corners_.size(); ++k) {
              on_side[k] = on_side[k] || is_end(corners_[k], x, y, 0) || is_end(corners_[k], x, y, K::degree);
            }
          }
        }
      }
    }
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      if (!on_side[k]) {
        contacts.corners.push_back(corners_[k]);
      }
    }
    return contacts;
  }

 private:
  /// False if a corner is two corners of the other patch, or perhaps one of them but for rounding.
  bool find_corners() {
    for (const std::size_t i : kCorners<K>) {
      for (const std::size_t j : kCorners<K>) {
        if (pair_.x.net[i] != pair_.y.net[j]) {
          continue;
        }
        const bool again = std::any_of(corners_.begin(), corners_.end(),
                                       [&](const CornerContact& c) { return c.x == i || c.y == j; });
        if (again || control_point(x_, i) != control_point(y_, j)) {
          return false;
        }
        corners_.push_back({i, j});
      }
    }
    return true;
  }

  bool same_side(const SideView& x, const SideView& y) const {
    for (std::size_t k = 0; k < K::side; ++k) {
      const std::size_t along = k == 1 ? K::degree : k == K::degree ? 1 : k;  // first the ends
      const std::size_t i = x.index(0, along);
      const std::size_t j = y.index(0, along);
      if (pair_.x.net[i] != pair_.y.net[j] || control_point(x_, i) != control_point(y_, j)) {
        return false;
      }
    }
    return true;
  }

  static bool is_end(const CornerContact& corner, const SideView& x, const SideView& y, std::size_t along) {
    return corner.x == x.index(0, along) && corner.y == y.index(0, along);
  }

  const ExactPatch<K>& x_;
  const ExactPatch<K>& y_;
  const PairOf<K>& pair_;
  std::vector<CornerContact> corners_;
};

using Interval = Part::Interval;

/// The part of v perpendicular to c, of length one; zero if it is not clear of zero.
Vec3 unit_across(const Vec3& v, const Vec3& c) {
  const Vec3 across = v - (dot(v, c) / dot(c, c)) * c;
  const double length = std::sqrt(dot(across, across));
  return length > 0x1p-30 ? (1 / length) * across : Vec3{0, 0, 0};
}

/// Of a mean of parameters, if those of y are taken to those of x: each of offset and factor errs by u times
/// its size, and the product, the sums and the mean by as much.
template <class K>
double mean_error(const SideContactOf<K>& contact) {
  return contact.path ? 4 * kUnit * (1 + std::fabs(contact.offset) + std::fabs(contact.factor)) : 0;
}

/// What is along y, in the parameter along x.
template <class K>
Interval along_on_x(const SideContactOf<K>& contact, const SideIntervals& on_y) {
  return {contact.offset + contact.factor * on_y.along.lower,
          contact.offset + contact.factor * on_y.along.upper};
}

template <class K>
bool may_touch(const SideContactOf<K>& contact, const SideIntervals& on_x, const SideIntervals& on_y) {
  const Interval y_along = along_on_x(contact, on_y);
  const double error = 2 * mean_error(contact);
  return on_x.across.lower == 0 && on_y.across.lower == 0 && on_x.along.lower <= y_along.upper + error &&
         y_along.lower - error <= on_x.along.upper;
}

/// Control vectors of D(t,t')/n where c(t) - c(t') = (t - t') D(t,t'): a convex set that contains all of its
/// values for t in the one, t' in the other interval. For a parabola D is c' at the mean, (14.12).
std::array<Vec3, 2> secant_net(const std::array<Vec3, 2>& d, const Interval& t, const Interval& other) {
  const Interval means = {0.5 * (t.lower + other.lower), 0.5 * (t.upper + other.upper)};
  return {between(d[0], d[1], means.lower), between(d[0], d[1], means.upper)};
}
/// (14.27): q(t,t) + q(t,t') + q(t',t'), q the blossom of d, divided by 3.
std::array<Vec3, 9> secant_net(const std::array<Vec3, 3>& d, const Interval& t, const Interval& other) {
  const auto q = [&](double a, double b) {
    return between(between(d[0], d[1], a), between(d[1], d[2], a), b);
  };
  const std::array<std::array<double, 2>, 3> first = {
      {{t.lower, t.lower}, {t.lower, t.upper}, {t.upper, t.upper}}};
  const std::array<std::array<double, 2>, 3> second = {
      {{other.lower, other.lower}, {other.lower, other.upper}, {other.upper, other.upper}}};
  std::array<Vec3, 9> net;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto& a = first[i];
      const auto& b = second[j];
      const Vec3 mixed = 0.25 * ((q(a[0], b[0]) + q(a[0], b[1])) + (q(a[1], b[0]) + q(a[1], b[1])));
      net[3 * i + j] = (1.0 / 3) * ((q(a[0], a[1]) + q(b[0], b[1])) + mixed);
    }
  }
  return net;
}

// (14.11) to (14.13). Where the parametrisations differ, a mean m errs by less than mean_error, C(m) by 4
// times that, w.X by 96 |n| times that; and the errors of C are those of its control vectors times |1-m| +
// |m| <= stretch.
template <class K>
bool meet_in_side(const SideContactOf<K>& contact, const SideIntervals& on_x, const SideIntervals& on_y,
                  double net_error) {
  const AcrossFieldOf<K> fx = restricted<K>(contact.x_across, on_x);
  const AcrossFieldOf<K> fy = restricted<K>(contact.y_across, on_y);
  const Interval y_along = along_on_x(contact, on_y);
  const Interval means = {0.5 * (on_x.along.lower + y_along.lower), 0.5 * (on_x.along.upper + y_along.upper)};
  const double stretch = 1 + 2 * std::max({0.0, -means.lower, means.upper - 1});
  const double extra = 100 * mean_error(contact);
  const auto c = secant_net(contact.direction, on_x.along, y_along);
  const Vec3 middle = c.front() + c.back();
  if (!(dot(middle, middle) > 0x1p-60)) {
    return false;
  }
  constexpr std::size_t inner = K::degree / 2;  // about the middle of the side
  const auto central = [&](const AcrossFieldOf<K>& f) {
    return f[inner] + f[K::side * (K::degree - 1) + inner];
  };
  const Vec3 n = cross(unit_across(central(fx), middle) - unit_across(central(fy), middle), middle);
  for (const Vec3& tangent : c) {
    const Vec3 w = cross(tangent, n);
    const double error = kSlack * (kSideError<K::degree> * net_error *
                                       (size1(w) + kSideNormal<K::degree> * stretch * largest(n)) +
                                   extra * largest(n)) +
                         kTiny;
    for (std::size_t k = 0; k < fx.size(); ++k) {
      if (!(dot(w, fx[k]) > error && dot(w, fy[k]) < -error)) {
        return false;
      }
    }
  }
  return true;
}

/// Vectors of length about one; zero vectors stay.
Vec3 unit(const Vec3& v) {
  const double square = dot(v, v);
  return square > 0 ? (1 / std::sqrt(square)) * v : v;
}

/// A guess of d with d.v > 0 for all v: Gilbert's method for the point of the convex hull nearest to zero.
template <std::size_t N>
Vec3 positive_direction(const std::array<Vec3, N>& vectors, std::size_t count) {
  Vec3 d = {0, 0, 0};
  for (std::size_t k = 0; k < count; ++k) {
    d = d + (1.0 / static_cast<double>(count)) * vectors[k];
  }
  for (int step = 0; step < kMostDirections; ++step) {
    std::size_t worst = 0;
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < count; ++k) {
      const double t = dot(d, vectors[k]);
      if (t < least) {
        least = t;
        worst = k;
      }
    }
    const Vec3 away = d - vectors[worst];
    const double square = dot(away, away);
    if (least > 0.25 * dot(d, d) || !(square > 0)) {
      break;
    }
    d = d - std::clamp(dot(d, away) / square, 0.0, 1.0) * away;
  }
  return d;
}

/// The index in the part's net of a corner of the square; `count` if it does not reach that far.
template <class K>
std::size_t own_corner(const Part& part, std::size_t corner) {
  const auto reaches = [](const Interval& range, bool upper) {
    return upper ? range.upper == 1 : range.lower == 0;
  };
  const std::array<bool, 2> upper = corner_ends<K>(corner);
  if (!reaches(part.range[0], upper[0]) || !reaches(part.range[1], upper[1])) {
    return part.points.size();
  }
  if (part.points.size() == K::count) {
    return corner;
  }
  const std::size_t along = part.range[0].lower == part.range[0].upper ? 1 : 0;
  return upper[along] ? K::degree : 0;
}

// (14.14). De Casteljau's algorithm keeps the corner's double. The bound is that of (14.2).
template <class K>
bool meet_in_corner(const Vec3& p, std::size_t corner_x, std::size_t corner_y, const Part& x, const Part& y,
                    double net_error) {
  std::array<Vec3, 2 * K::count> vectors;
  std::array<Vec3, 2 * K::count> units{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < x.points.size(); ++k) {
    if (k != corner_x) {
      vectors[count++] = x.points[k] - p;
    }
  }
  for (std::size_t k = 0; k < y.points.size(); ++k) {
    if (k != corner_y) {
      vectors[count++] = p - y.points[k];
    }
  }
  std::transform(vectors.begin(), vectors.begin() + count, units.begin(), unit);
  const Vec3 d = positive_direction(units, count);
  const double error = kSlack * kSeparation * net_error * size1(d) + kTiny;
  return std::all_of(vectors.begin(), vectors.begin() + count,
                     [&](const Vec3& v) { return dot(d, v) > error; });
}

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

SideContact part_of_side(const SidePath& path, const std::array<SquareSide, 2>& sides, const Pair& pair) {
  const std::size_t along = 1 - sides[path.of_x ? 1 : 0].parameter;
  const Rational& from = path.ends[0][along];
  const Rational& to = path.ends[1][along];
  const bool reversed = to < from;
  SideContact contact = side_contact<Biquadratic>(pair, {sides[0], false}, {sides[1], reversed});
  contact.path = path;
  const Rational length = abs(to - from);
  // Along the line the parameter is from + (to - from) t; t of x and t' of y, 1 - t' if reversed.
  contact.factor = to_double(path.of_x ? 1 / length : length);
  contact.offset =
      path.of_x ? to_double(-(reversed ? 1 - from : from) / length) : to_double(reversed ? to : from);
  return contact;
}

}  // namespace

void add_path(const SidePath& path, const Pair& pair, Contacts& contacts) {
  if (const auto sides = common_sides(path)) {
    const auto is_same = [&](const SideContact& known) {
      return known.x.side == (*sides)[0] && known.y.side == (*sides)[1];
    };
    if (std::none_of(contacts.sides.begin(), contacts.sides.end(), is_same)) {
      contacts.sides.push_back(part_of_side(path, *sides, pair));
    }
  } else {
    contacts.paths.push_back(path_contact(path, pair));
  }
  for (const Rational& t : {path.common.lower, path.common.upper}) {
    const auto at = path.at(t);
    std::erase_if(contacts.corners, [&](const CornerContact& corner) {
      return corner_of(at[0], at[1]) == corner.x && corner_of(at[2], at[3]) == corner.y;
    });
  }
}

template <class K>
std::optional<ContactsOf<K>> find_contacts(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                           const PairOf<K>& pair) {
  if constexpr (K::weighted) {
    return ContactsOf<K>{};  // the searches find no way past one
  } else {
    return ContactFinder<K>(x, y, pair).run();
  }
}

template <class K>
Meeting meeting([[maybe_unused]] const PairOf<K>& pair, [[maybe_unused]] const ContactsOf<K>& contacts,
                [[maybe_unused]] const Part& x, [[maybe_unused]] const Part& y) {
  if constexpr (!K::weighted) {
    bool touching = false;
    for (const SideContactOf<K>& side : contacts.sides) {
      const SideIntervals on_x = intervals(side.x, x);
      const SideIntervals on_y = intervals(side.y, y);
      if (meet_in_side(side, on_x, on_y, pair.net_error)) {
        return Meeting::contact;
      }
      touching = touching || may_touch(side, on_x, on_y);
    }
    if constexpr (std::is_same_v<K, Biquadratic>) {
      for (const PathContact& path : contacts.paths) {
        if (meet_on_line(pair, path, x, y)) {
          return Meeting::contact;
        }
        touching = touching || may_touch(path, x, y);
      }
    }
    for (const CornerContact& corner : contacts.corners) {
      const std::size_t i = own_corner<K>(x, corner.x);
      const std::size_t j = own_corner<K>(y, corner.y);
      if (meet_in_corner<K>(pair.x.net[corner.x], i, j, x, y, pair.net_error)) {
        return Meeting::contact;
      }
      touching = touching || (i < x.points.size() && j < y.points.size());
    }
    return touching ? Meeting::touching : Meeting::unknown;
  } else {
    return Meeting::unknown;
  }
}

template <class K>
bool meet_in_contacts_only(const PairOf<K>& pair, TreesOf<K>& trees, const ContactsOf<K>& contacts,
                           long& boxes) {
  std::vector<PiecePair> stack = {{0, 0}};
  for (long count = 0; !stack.empty(); ++count) {
    const PiecePair item = stack.back();
    stack.pop_back();
    ++boxes;
    const SubPatchOf<K>& x = trees.x[item.x];
    const SubPatchOf<K>& y = trees.y[item.y];
    if (separated(x, y, pair.net_error) ||
        meeting<K>(pair, contacts, part_of(x), part_of(y)) == Meeting::contact) {
      continue;
    }
    if (count > kMostBoxes || x.level + y.level >= kDeepest) {
      return false;
    }
    trees.split_larger(item, stack);
  }
  return true;
}

#define EXSECT_INSTANTIATE(K)                                                                        \
  template std::optional<ContactsOf<K>> find_contacts<K>(const ExactPatch<K>&, const ExactPatch<K>&, \
                                                         const PairOf<K>&);                          \
  template Meeting meeting<K>(const PairOf<K>&, const ContactsOf<K>&, const Part&, const Part&);     \
  template bool meet_in_contacts_only<K>(const PairOf<K>&, TreesOf<K>&, const ContactsOf<K>&, long&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
