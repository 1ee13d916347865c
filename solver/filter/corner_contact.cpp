#include "filter/corner_contact.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

constexpr int kMostDirections = 40;
/// Square of the distance of a hull of unit vectors from zero below which no direction is looked for.
constexpr double kNearlyZero = 0x1p-12;

/// The ranges of both parameters, or of that across the pole's side, fulfil condition(range, is at upper
/// end).
template <class K, class Condition>
bool at_corner(const Part& part, std::size_t corner, const std::optional<SquareSide>& pole,
               const Condition& condition) {
  const std::array<bool, 2> upper = corner_ends<K>(corner);
  const auto holds = [&](std::size_t i) { return condition(part.range[i], upper[i]); };
  return pole ? holds(pole->parameter) : holds(0) && holds(1);
}

/// The part reaches this end of a side, or all of the pole there.
template <class K>
bool reaches(const Part& part, std::size_t corner, const std::optional<SquareSide>& pole) {
  return at_corner<K>(part, corner, pole, [](const auto& range, bool upper) {
    return upper ? range.upper == 1 : range.lower == 0;
  });
}

/// The part is within `reach` of the corner, or of the pole's side, exactly.
template <class K>
bool lies_within(double reach, const Part& part, std::size_t corner, const std::optional<SquareSide>& pole) {
  return at_corner<K>(part, corner, pole, [&](const auto& range, bool upper) {
    return upper ? range.lower >= 1 - reach : range.upper <= reach;
  });
}

/// Vectors of length about one; zero vectors stay.
Vec3 unit(const Vec3& v) {
  const double square = dot(v, v);
  return square > 0 ? (1 / std::sqrt(square)) * v : v;
}

/// A guess of d with d.v > 0 for all v: their mean, else the point of the convex hull nearest to zero, by the
/// method of Mitchell, Dem'yanov and Malozemov: weight moves from the vector farthest along d to the nearest.
template <std::size_t N>
Vec3 positive_direction(const std::array<Vec3, N>& vectors, std::size_t count) {
  std::array<double, N> weight;
  weight.fill(1.0 / static_cast<double>(count));
  Vec3 d = {0, 0, 0};
  for (std::size_t k = 0; k < count; ++k) d = d + weight[k] * vectors[k];
  for (int step = 0; step < kMostDirections; ++step) {
    std::size_t nearest = 0, farthest = 0;
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (std::size_t k = 0; k < count; ++k) {
      const double t = dot(d, vectors[k]);
      if (t < least) least = t, nearest = k;
      if (t > most && weight[k] > 0) most = t, farthest = k;
    }
    const double square = dot(d, d);
    if (least > 0.25 * square || square < kNearlyZero) break;
    if (step == 0) {
      weight.fill(0);
      weight[nearest] = 1;
      d = vectors[nearest];
      continue;
    }
    const Vec3 away = vectors[farthest] - vectors[nearest];
    if (!(dot(away, away) > 0)) break;
    const double moved = std::min(weight[farthest], (most - least) / dot(away, away));
    weight[farthest] -= moved;
    weight[nearest] += moved;
    d = d - moved * away;
  }
  return d;
}

/// Which control points of the part are the corner, or on the pole, exactly.
template <class K>
std::array<bool, K::count> own_points(const Part& part, std::size_t corner,
                                      const std::optional<SquareSide>& pole, const Repeated& repeated) {
  std::array<bool, K::count> own{};
  if (!reaches<K>(part, corner, pole)) {
    return own;
  }
  const std::array<bool, 2> upper = corner_ends<K>(corner);
  const bool has_corner = reaches<K>(part, corner, std::nullopt);
  const bool is_curve = part.points.size() == K::side;  // on a line where the other parameter is fixed
  const std::size_t along = part.range[0].lower == part.range[0].upper ? 1 : 0;
  for (std::size_t k = 0; k < part.points.size(); ++k) {
    std::array<std::size_t, 2> at = {k / K::side, k % K::side};  // counted from the corner
    if (is_curve) at = along == 0 ? std::array{k, std::size_t{0}} : std::array{std::size_t{0}, k};
    for (std::size_t p = 0; p < 2; ++p) {
      if (upper[p] && (!is_curve || p == along)) at[p] = K::degree - at[p];
    }
    own[k] = (pole && at[pole->parameter] == 0) ||
             (has_corner && ((at[1] == 0 && at[0] <= repeated[0]) || (at[0] == 0 && at[1] <= repeated[1])));
  }
  return own;
}

}  // namespace

template <class K>
bool may_touch(const CornerContact& corner, const Part& x, const Part& y) {
  return reaches<K>(x, corner.x, corner.pole_of_x) && reaches<K>(y, corner.y, corner.pole_of_y);
}

// (14.14). De Casteljau's algorithm keeps the corner's double, and those of a pole. The bound is that of
// (14.2).
template <class K>
bool meet_in_corner(const Vec3& p, const CornerContact& corner, const Part& x, const Part& y,
                    double net_error) {
  if (corner.lone_reach > 0 && lies_within<K>(corner.lone_reach, x, corner.x, corner.pole_of_x) &&
      lies_within<K>(corner.lone_reach, y, corner.y, corner.pole_of_y))
    return true;  // (14.14a)
  const double points_error = larger_bound(net_error, x.error, y.error);
  const auto own_x = own_points<K>(x, corner.x, corner.pole_of_x, corner.repeated_of_x);
  const auto own_y = own_points<K>(y, corner.y, corner.pole_of_y, corner.repeated_of_y);
  std::array<Vec3, 2 * K::count> vectors;
  std::array<Vec3, 2 * K::count> units{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < x.points.size(); ++k) {
    if (!own_x[k]) {
      vectors[count++] = x.points[k] - p;
    }
  }
  for (std::size_t k = 0; k < y.points.size(); ++k) {
    if (!own_y[k]) {
      vectors[count++] = p - y.points[k];
    }
  }
  std::transform(vectors.begin(), vectors.begin() + count, units.begin(), unit);
  if (count == 0) return true;  // both are the pole alone
  const Vec3 d = positive_direction(units, count);
  const double error = kSlack * kSeparation * points_error * size1(d) + kTiny;
  return std::all_of(vectors.begin(), vectors.begin() + count,
                     [&](const Vec3& v) { return dot(d, v) > error; });
}

#define EXSECT_INSTANTIATE(K)                                                 \
  template bool may_touch<K>(const CornerContact&, const Part&, const Part&); \
  template bool meet_in_corner<K>(const Vec3&, const CornerContact&, const Part&, const Part&, double);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
