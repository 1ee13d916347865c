#include "filter/contact.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace exsect::filter {

namespace {

constexpr long kMostBoxes = 600;
constexpr int kDeepest = 24;  // levels of both patches together

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
requires(!K::weighted) double mean_error(const SideContactOf<K>& contact) {
  return contact.path ? 4 * kUnit * (1 + std::fabs(contact.offset) + std::fabs(contact.factor)) : 0;
}

/// What is along y, in the parameter along x.
template <class K>
requires(!K::weighted) Interval along_on_x(const SideContactOf<K>& contact, const SideIntervals& on_y) {
  return {contact.offset + contact.factor * on_y.along.lower,
          contact.offset + contact.factor * on_y.along.upper};
}

template <class K>
requires(!K::weighted) bool may_touch(const SideContactOf<K>& contact, const SideIntervals& on_x,
                                      const SideIntervals& on_y) {
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
// |m| <= stretch. Of cubics an error of t' changes D/3 by (4 + 8)/3 = 4 times that and |1-t'| + |t'|, and w.X
// with control vectors of size 6 by 144 |n| times that; and control vectors of D are means of products of two
// such sums.
template <class K>
requires(!K::weighted) bool meet_in_side(const SideContactOf<K>& contact, const SideIntervals& on_x,
                                         const SideIntervals& on_y, double net_error) {
  const AcrossFieldOf<K> fx = restricted<K>(contact.x_across, on_x);
  const AcrossFieldOf<K> fy = restricted<K>(contact.y_across, on_y);
  const Interval y_along = along_on_x(contact, on_y);
  const Interval means = {0.5 * (on_x.along.lower + y_along.lower), 0.5 * (on_x.along.upper + y_along.upper)};
  // For cubics D is quadratic in a point t of x's side and one of y's, which may be beyond it.
  const Interval& farthest = K::degree == 2 ? means : y_along;
  const double linear = 1 + 2 * std::max({0.0, -farthest.lower, farthest.upper - 1});
  const double stretch = K::degree == 2 ? linear : linear * linear;
  const double extra = (K::degree == 2 ? 100 : 150 * linear) * mean_error(contact);
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
    const double error =
        kSlack * contact.growth *
            (kSideError<K::degree> * net_error * (size1(w) + kSideNormal<K::degree> * stretch * largest(n)) +
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

/// t' and t' up to rounding: value and weight err by 4 u times the sums of their sizes, with the rounding of
/// their coefficients; so the quotient by twice that over a weight that is at least half of what is computed.
/// Empty if the weight may be zero.
std::optional<Interval> mapped(const MoebiusMap<double>& map, double t) {
  const auto mean = [&](const std::array<double, 2>& ends) { return (1 - t) * ends[0] + t * ends[1]; };
  const auto size = [](const std::array<double, 2>& ends) { return std::fabs(ends[0]) + std::fabs(ends[1]); };
  const double weight = mean(map.weight);
  if (!(weight > 16 * kUnit * size(map.weight) + kTiny)) return std::nullopt;
  const double value = mean(map.value) / weight;
  const double error =
      kSlack * 10 * kUnit * (size(map.value) + std::fabs(value) * size(map.weight)) / weight + kTiny;
  return Interval{value - error, value + error};
}

/// Around what is along y, in the parameter along x; empty if a pole of the map may be there.
template <class K>
requires K::weighted std::optional<Interval> along_on_x(const SideContactOf<K>& contact,
                                                        const SideIntervals& on_y) {
  const auto lower = mapped(contact.rounded_to_x, on_y.along.lower);
  const auto upper = mapped(contact.rounded_to_x, on_y.along.upper);
  if (!lower || !upper) return std::nullopt;
  return Interval{lower->lower, upper->upper};
}

template <class K>
requires K::weighted bool may_touch(const SideContactOf<K>& contact, const SideIntervals& on_x,
                                    const SideIntervals& on_y) {
  const std::optional<Interval> y_along = along_on_x<K>(contact, on_y);
  return on_x.across.lower == 0 && on_y.across.lower == 0 &&
         !(y_along && (on_x.along.lower > y_along->upper || y_along->lower > on_x.along.upper));
}

/// A net of bidegree (n-1,n-1) in (t,t') on two intervals.
template <std::size_t N>
std::array<Vec3, N * N> on_intervals(const std::array<Vec3, N * N>& net, const Interval& t,
                                     const Interval& other) {
  std::array<Vec3, N * N> rows;
  for (std::size_t i = 0; i < N; ++i) {
    std::array<Vec3, N> row;
    std::copy_n(&net[N * i], N, row.begin());
    for (std::size_t j = 0; j < N; ++j) rows[N * i + j] = restricted_point(row, other, j);
  }
  std::array<Vec3, N * N> result;
  for (std::size_t j = 0; j < N; ++j) {
    std::array<Vec3, N> column;
    for (std::size_t i = 0; i < N; ++i) column[i] = rows[N * i + j];
    for (std::size_t i = 0; i < N; ++i) result[N * i + j] = restricted_point(column, t, i);
  }
  return result;
}

// (14.35), (14.36). Of parts of sides t' may be beyond x's side: the control vectors of K are means with
// weights of sums stretch^(n-1).
template <class K>
requires K::weighted bool meet_in_side(const SideContactOf<K>& contact, const SideIntervals& on_x,
                                       const SideIntervals& on_y, double net_error) {
  constexpr std::size_t n = K::degree;
  const AcrossFieldOf<K> fx = restricted<K>(contact.x_across, on_x);
  const AcrossFieldOf<K> fy = restricted<K>(contact.y_across, on_y);
  const std::optional<Interval> y_along = along_on_x<K>(contact, on_y);
  if (!y_along) return false;
  const auto line = on_intervals<n>(contact.line, on_x.along, *y_along);
  const auto moment = on_intervals<n>(contact.line_moment, on_x.along, *y_along);
  const Vec3 along = line.front() + line.back();
  if (!(dot(along, along) > 0x1p-60)) {
    return false;
  }
  const double middle = 0.5 * (on_x.along.lower + on_x.along.upper);
  const Vec3 point = affine(restricted_point(contact.own, {middle, middle}, 0));
  const auto across = [&](const AcrossFieldOf<K>& f) {
    constexpr std::size_t inner = n / 2;  // about the middle of the side
    const Row<K> v = f[inner] + f[K::side * (n - 1) + inner];
    return unit_across({v[0] - point[0] * v[3], v[1] - point[1] * v[3], v[2] - point[2] * v[3]}, along);
  };
  const Vec3 normal = cross(across(fx) - across(fy), along);
  const double linear = 1 + 2 * std::max({0.0, -y_along->lower, y_along->upper - 1});
  const double stretch = n == 2 ? linear : linear * linear;
  for (std::size_t k = 0; k < n * n; ++k) {
    const Vec3 part = cross(line[k], normal);
    const Vec4 plane = {part[0], part[1], part[2], dot(moment[k], normal)};
    const double size = std::fabs(normal[0]) + std::fabs(normal[1]) + std::fabs(normal[2]);
    const double error =
        kSlack * contact.growth * net_error * (size1(plane) + kPlaneError * stretch * size) + kTiny;
    for (std::size_t i = 0; i < fx.size(); ++i) {
      if (!(dot(plane, fx[i]) > error && dot(plane, fy[i]) < -error)) {
        return false;
      }
    }
  }
  return true;
}

/// All points of the parts are in the region.
template <class K>
bool is_around(const DoublePointOf<K>& point, const Part& x, const Part& y) {
  Vec4 middle;
  Vec4 half;
  for (std::size_t j = 0; j < 4; ++j) {
    const Interval& range = (j < 2 ? x : y).range[j % 2];
    middle[j] = 0.5 * (range.lower + range.upper) - 0.5;
    half[j] = 0.5 * (range.upper - range.lower);
  }
  return lies_in_region(point, middle, half);
}

}  // namespace

template <class K>
Meeting meeting(const PairOf<K>& pair, const ContactsOf<K>& contacts, const Part& x, const Part& y) {
  if (std::any_of(contacts.boxes.begin(), contacts.boxes.end(),
                  [&](const KnownBox& box) { return lie_in(box, x, y); })) {
    return Meeting::contact;
  }
  if (std::any_of(contacts.points.begin(), contacts.points.end(),
                  [&](const SidePointOf<K>& point) { return lies_in_region(point, x, y); }) ||
      std::any_of(contacts.double_points.begin(), contacts.double_points.end(),
                  [&](const DoublePointOf<K>& point) { return is_around(point, x, y); })) {
    return Meeting::contact;
  }
  bool touching = false;
  for (const SideContactOf<K>& side : contacts.sides) {
    const SideIntervals on_x = intervals(side.x, x);
    const SideIntervals on_y = intervals(side.y, y);
    if (meet_in_side(side, on_x, on_y, pair.net_error)) {
      return Meeting::contact;
    }
    touching = touching || may_touch(side, on_x, on_y) ||
               std::any_of(side.ends.begin(), side.ends.end(),
                           [&](const CornerContact& end) { return may_touch<K>(end, x, y); });
  }
  if constexpr (std::is_same_v<K, Biquadratic>) {
    for (const PathContact& path : contacts.paths) {
      if (meet_on_line(pair, path, x, y)) {
        return Meeting::contact;
      }
      touching = touching || may_touch(path, x, y);
    }
  } else {
    for (const ContactLineOf<K>& line : contacts.lines) {
      if (meet_on_line(line, x, y)) return Meeting::contact;
      touching = touching || may_touch(line, x, y);
    }
  }
  for (const auto* corners : {&contacts.corners, &contacts.branched})
    for (const CornerContact& corner : *corners) {
      if (meet_in_corner<K>(affine(pair.x.net[corner.x]), corner, x, y, pair.net_error)) {
        return Meeting::contact;
      }
      touching = touching || may_touch<K>(corner, x, y);
    }
  return touching ? Meeting::touching : Meeting::unknown;
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

#define EXSECT_INSTANTIATE(K)                                                                    \
  template Meeting meeting<K>(const PairOf<K>&, const ContactsOf<K>&, const Part&, const Part&); \
  template bool meet_in_contacts_only<K>(const PairOf<K>&, TreesOf<K>&, const ContactsOf<K>&, long&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
