#include "filter/contact.h"

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

constexpr long kMostBoxes = 600;
constexpr int kDeepest = 24;  // levels of both patches together
constexpr int kMostDirections = 12;

constexpr std::array<std::size_t, 4> kCorners = {0, 2, 6, 8};
constexpr std::array<SquareSide, 4> kSides = {{{0, false}, {0, true}, {1, false}, {1, true}}};

const Point& control_point(const BezierPatch& patch, std::size_t i) { return patch.net()[i / 3][i % 3]; }

double size1(const Vec3& a) { return std::fabs(a[0]) + std::fabs(a[1]) + std::fabs(a[2]); }

SideContact side_contact(const Pair& pair, const SideView& x, const SideView& y) {
  SideContact contact{x, y, {}, across_field(pair.x.net, x), across_field(pair.y.net, y)};
  for (std::size_t j = 0; j < 2; ++j) {
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

class ContactFinder {
 public:
  ContactFinder(const BezierPatch& x, const BezierPatch& y, const Pair& pair) : x_(x), y_(y), pair_(pair) {}

  std::optional<Contacts> run() {
    if (!find_corners()) {
      return std::nullopt;
    }
    Contacts contacts;
    std::vector<bool> on_side(corners_.size(), false);
    for (const SquareSide& a : kSides) {
      for (const SquareSide& b : kSides) {
        for (const bool reversed : {false, true}) {
          const SideView x = {a, false};
          const SideView y = {b, reversed};
          if (same_side(x, y)) {
            contacts.sides.push_back(side_contact(pair_, x, y));
            for (std::size_t k = 0; k < corners_.size(); ++k) {
              on_side[k] = on_side[k] || is_end(corners_[k], x, y, 0) || is_end(corners_[k], x, y, 2);
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
    for (const std::size_t i : kCorners) {
      for (const std::size_t j : kCorners) {
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
    for (const std::size_t along : {0, 2, 1}) {
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

  const BezierPatch& x_;
  const BezierPatch& y_;
  const Pair& pair_;
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
double mean_error(const SideContact& contact) {
  return contact.path ? 4 * kUnit * (1 + std::fabs(contact.offset) + std::fabs(contact.factor)) : 0;
}

/// What is along y, in the parameter along x.
Interval along_on_x(const SideContact& contact, const SideIntervals& on_y) {
  return {contact.offset + contact.factor * on_y.along.lower,
          contact.offset + contact.factor * on_y.along.upper};
}

bool may_touch(const SideContact& contact, const SideIntervals& on_x, const SideIntervals& on_y) {
  const Interval y_along = along_on_x(contact, on_y);
  const double error = 2 * mean_error(contact);
  return on_x.across.lower == 0 && on_y.across.lower == 0 && on_x.along.lower <= y_along.upper + error &&
         y_along.lower - error <= on_x.along.upper;
}

// (14.11) to (14.13). Where the parametrisations differ, a mean m errs by less than mean_error, C(m) by 4
// times that, w.X by 96 |n| times that; and the errors of C are those of its control vectors times |1-m| +
// |m| <= stretch.
bool meet_in_side(const SideContact& contact, const SideIntervals& on_x, const SideIntervals& on_y,
                  double net_error) {
  const AcrossField fx = restricted(contact.x_across, on_x);
  const AcrossField fy = restricted(contact.y_across, on_y);
  const auto& d = contact.direction;
  const Interval y_along = along_on_x(contact, on_y);
  const Interval means = {0.5 * (on_x.along.lower + y_along.lower), 0.5 * (on_x.along.upper + y_along.upper)};
  const double stretch = 1 + 2 * std::max({0.0, -means.lower, means.upper - 1});
  const double extra = 100 * mean_error(contact);
  const std::array<Vec3, 2> c = {between(d[0], d[1], means.lower), between(d[0], d[1], means.upper)};
  const Vec3 middle = c[0] + c[1];
  if (!(dot(middle, middle) > 0x1p-60)) {
    return false;
  }
  const Vec3 n = cross(unit_across(fx[1] + fx[4], middle) - unit_across(fy[1] + fy[4], middle), middle);
  for (const Vec3& tangent : c) {
    const Vec3 w = cross(tangent, n);
    const double error = kSlack * (kSideError * net_error * (size1(w) + kSideNormal * stretch * largest(n)) +
                                   extra * largest(n)) +
                         kTiny;
    for (std::size_t k = 0; k < 6; ++k) {
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
Vec3 positive_direction(const std::array<Vec3, 18>& vectors, std::size_t count) {
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
std::size_t own_corner(const Part& part, std::size_t corner) {
  const auto reaches = [](const Interval& range, bool upper) {
    return upper ? range.upper == 1 : range.lower == 0;
  };
  const std::array<bool, 2> upper = {corner >= 6, corner % 3 == 2};
  if (!reaches(part.range[0], upper[0]) || !reaches(part.range[1], upper[1])) {
    return part.points.size();
  }
  if (part.points.size() == 9) {
    return corner;
  }
  const std::size_t along = part.range[0].lower == part.range[0].upper ? 1 : 0;
  return upper[along] ? 2 : 0;
}

// (14.14). De Casteljau's algorithm keeps the corner's double. The bound is that of (14.2).
bool meet_in_corner(const Vec3& p, std::size_t corner_x, std::size_t corner_y, const Part& x, const Part& y,
                    double net_error) {
  std::array<Vec3, 18> vectors;
  std::array<Vec3, 18> units;
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
  SideContact contact = side_contact(pair, {sides[0], false}, {sides[1], reversed});
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

std::optional<Contacts> find_contacts(const BezierPatch& x, const BezierPatch& y, const Pair& pair) {
  return ContactFinder(x, y, pair).run();
}

Meeting meeting(const Pair& pair, const Contacts& contacts, const Part& x, const Part& y) {
  bool touching = false;
  for (const SideContact& side : contacts.sides) {
    const SideIntervals on_x = intervals(side.x, x);
    const SideIntervals on_y = intervals(side.y, y);
    if (meet_in_side(side, on_x, on_y, pair.net_error)) {
      return Meeting::contact;
    }
    touching = touching || may_touch(side, on_x, on_y);
  }
  for (const PathContact& path : contacts.paths) {
    if (meet_on_line(pair, path, x, y)) {
      return Meeting::contact;
    }
    touching = touching || may_touch(path, x, y);
  }
  for (const CornerContact& corner : contacts.corners) {
    const std::size_t i = own_corner(x, corner.x);
    const std::size_t j = own_corner(y, corner.y);
    if (meet_in_corner(pair.x.net[corner.x], i, j, x, y, pair.net_error)) {
      return Meeting::contact;
    }
    touching = touching || (i < x.points.size() && j < y.points.size());
  }
  return touching ? Meeting::touching : Meeting::unknown;
}

bool meet_in_contacts_only(const Pair& pair, Trees& trees, const Contacts& contacts, long& boxes) {
  std::vector<PiecePair> stack = {{0, 0}};
  for (long count = 0; !stack.empty(); ++count) {
    const PiecePair item = stack.back();
    stack.pop_back();
    ++boxes;
    const SubPatch& x = trees.x[item.x];
    const SubPatch& y = trees.y[item.y];
    if (separated(x, y, pair.net_error) ||
        meeting(pair, contacts, part_of(x), part_of(y)) == Meeting::contact) {
      continue;
    }
    if (count > kMostBoxes || x.level + y.level >= kDeepest) {
      return false;
    }
    trees.split_larger(item, stack);
  }
  return true;
}

}  // namespace exsect::filter
