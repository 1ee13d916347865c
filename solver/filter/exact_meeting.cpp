#include "filter/exact_meeting.h"

#include <algorithm>
#include <vector>

#include "filter/homogeneous.h"

namespace exsect::filter {

namespace {

using Vector = HomogeneousPoint;

/// How near simple numbers have to be.
constexpr long kSimpleBits = 36;
/// Half widths of the squares in which a common point of two curves is proved.
constexpr std::array<int, 3> kSquareBits = {40, 34, 30};

Rational uncentred(double t) { return from_double(t) + Rational(1, 2); }

template <class K>
std::optional<ExactMeeting> meeting_in_simple_numbers(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                      const Vec4& place, const Vec4& on) {
  const Rational room = power_of_two(-kSimpleBits);
  std::array<Rational, 4> w;
  ExactMeeting result{on, 2 * kUnit, {}};
  for (std::size_t j = 0; j < 4; ++j) {
    w[j] = on[j] != 0 ? uncentred(on[j])
                      : simplest_between(uncentred(place[j]) - room, uncentred(place[j]) + room);
    result.at[j] = to_double(w[j] - Rational(1, 2));
  }
  const FirstOrder<K> a(x, w[0], w[1]);
  const FirstOrder<K> b(y, w[2], w[3]);
  if (!is_same_point(a.value, b.value)) return std::nullopt;
  result.exact = {w[0], w[1], w[2], w[3]};
  // (14.31) without the factor: the derivatives modulo the point.
  for (std::size_t i = 0; i < 2; ++i) {
    result.still[i] = determinant(a.value, a.derivative[1 - i], b.derivative[0], b.derivative[1]) == 0;
    result.still[2 + i] = determinant(a.value, b.derivative[1 - i], a.derivative[0], a.derivative[1]) == 0;
  }
  return result;
}

/// Control vectors of a side, and of the row next to it.
template <class K>
struct Side {
  std::array<Vector, K::side> own;
  std::array<Vector, K::side> next;

  Side(const ExactPatch<K>& patch, const SquareSide& side) {
    const SideView view = {side, false, K::degree};
    for (std::size_t k = 0; k < K::side; ++k) {
      own[k] = homogeneous<K>(patch, view.index(0, k));
      next[k] = homogeneous<K>(patch, view.index(1, k));
    }
  }
};

/// A coordinate of space that the others determine on the only plane through all vectors; empty if there is
/// no plane, or more than one.
std::optional<std::size_t> dependent_coordinate(std::vector<Vector> vectors) {
  // Gauss' elimination: three pivots are left of a plane.
  std::array<std::size_t, 3> pivots{};
  std::size_t rank = 0;
  for (std::size_t column : {3U, 0U, 1U, 2U}) {
    const auto row = std::find_if(vectors.begin() + static_cast<std::ptrdiff_t>(rank), vectors.end(),
                                  [&](const Vector& v) { return v[column] != 0; });
    if (row == vectors.end()) continue;
    if (rank == 3) return std::nullopt;
    std::swap(vectors[rank], *row);
    for (std::size_t i = rank + 1; i < vectors.size(); ++i) {
      const Rational factor = vectors[i][column] / vectors[rank][column];
      if (factor != 0) vectors[i] = combined(1, vectors[i], -factor, vectors[rank]);
    }
    pivots[rank++] = column;
  }
  if (rank != 3) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::find(pivots.begin(), pivots.end(), k) == pivots.end()) return k;
  }
  return std::nullopt;
}

/// The next row is c times the own one plus multiples of one vector of space, the first that is not zero:
/// then the derivative across the side has the direction of that vector, all along it.
template <class K>
bool is_across(const Side<K>& side, std::optional<Point>& direction) {
  const auto weight =
      std::find_if(side.own.begin(), side.own.end(), [](const Vector& p) { return p[3] != 0; });
  if (weight == side.own.end()) return false;
  const auto index = static_cast<std::size_t>(weight - side.own.begin());
  const Rational c = side.next[index][3] / side.own[index][3];
  for (std::size_t k = 0; k < K::side; ++k) {
    const Vector v = combined(1, side.next[k], -c, side.own[k]);
    if (v[3] != 0) return false;
    const Point across = {v[0], v[1], v[2]};
    if (across == Point{0, 0, 0}) continue;
    if (!direction) direction = across;
    if (exsect::cross(*direction, across) != Point{0, 0, 0}) return false;
  }
  return true;
}

/// Three coordinates of a curve at t, its derivative, and bounds of both and of the second derivative in
/// [0,1].
template <class K>
struct PlaneCurve {
  std::array<Rational, 3> value;
  std::array<Rational, 3> first;
  std::array<std::array<Rational, 3>, 3> most;  // by order

  PlaneCurve(const std::array<Vector, K::side>& points, const std::array<std::size_t, 3>& coordinates,
             const Rational& t) {
    const auto [tangent, at] = tangent_and_value(points, t);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = coordinates[i];
      value[i] = at[k];
      first[i] = Rational(K::degree) * tangent[k];
      std::vector<Rational> c;
      for (const Vector& p : points) c.push_back(p[k]);
      for (std::size_t order = 0; order < 3; ++order) {
        most[order][i] = 0;
        for (const Rational& a : c) most[order][i] = std::max(most[order][i], Rational(abs(a)));
        for (std::size_t j = 0; j + 1 < c.size(); ++j) {
          c[j] = Rational(K::degree - order) * (c[j + 1] - c[j]);
        }
        c.pop_back();
      }
    }
  }
};

/// (14.33): a zero of a_i b_w - b_i a_w, i = 0, 1, within `room` of the place.
template <class K>
bool has_zero_near(const PlaneCurve<K>& a, const PlaneCurve<K>& b, const Rational& room) {
  std::array<Rational, 2> g;
  std::array<std::array<Rational, 2>, 2> jacobian;
  std::array<std::array<Rational, 2>, 2> change;  // of the Jacobian
  for (std::size_t i = 0; i < 2; ++i) {
    g[i] = a.value[i] * b.value[2] - b.value[i] * a.value[2];
    jacobian[i] = {a.first[i] * b.value[2] - b.value[i] * a.first[2],
                   a.value[i] * b.first[2] - b.first[i] * a.value[2]};
    const Rational mixed = a.most[1][i] * b.most[1][2] + b.most[1][i] * a.most[1][2];
    change[i] = {room * (a.most[2][i] * b.most[0][2] + b.most[0][i] * a.most[2][2] + mixed),
                 room * (a.most[0][i] * b.most[2][2] + b.most[2][i] * a.most[0][2] + mixed)};
  }
  const Rational det = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
  if (det == 0) return false;
  const std::array<std::array<Rational, 2>, 2> inverse = {
      {{jacobian[1][1] / det, -jacobian[0][1] / det}, {-jacobian[1][0] / det, jacobian[0][0] / det}}};
  for (std::size_t i = 0; i < 2; ++i) {
    Rational far = abs(Rational(inverse[i][0] * g[0] + inverse[i][1] * g[1]));
    for (std::size_t k = 0; k < 2; ++k) {
      far += room * (abs(inverse[i][0]) * change[0][k] + abs(inverse[i][1]) * change[1][k]);
    }
    if (far > room) return false;
  }
  return true;
}

template <class K>
std::optional<ExactMeeting> meeting_in_plane(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                             const Vec4& place, const Vec4& on) {
  if ((on[0] != 0) == (on[1] != 0) || (on[2] != 0) == (on[3] != 0)) return std::nullopt;
  const std::size_t across_x = on[0] != 0 ? 0 : 1;
  const std::size_t across_y = on[2] != 0 ? 0 : 1;
  const std::size_t along_x = 1 - across_x;
  const std::size_t along_y = 3 - across_y;
  const Side<K> a(x, {across_x, on[across_x] > 0});
  const Side<K> b(y, {across_y, on[2 + across_y] > 0});
  std::vector<Vector> all(a.own.begin(), a.own.end());
  all.insert(all.end(), b.own.begin(), b.own.end());
  const auto dependent = dependent_coordinate(std::move(all));
  if (!dependent) return std::nullopt;
  const std::array<std::size_t, 3> coordinates = {*dependent == 0 ? 1U : 0U, *dependent == 2 ? 1U : 2U, 3U};
  const Rational u = uncentred(place[along_x]);
  const Rational r = uncentred(place[along_y]);
  const PlaneCurve<K> on_x(a.own, coordinates, u);
  const PlaneCurve<K> on_y(b.own, coordinates, r);
  for (const int bits : kSquareBits) {
    const Rational room = power_of_two(-bits);
    const auto fits = [&](const Rational& t) { return t >= room && t + room <= 1; };
    if (!fits(u) || !fits(r) || !has_zero_near(on_x, on_y, room)) continue;
    ExactMeeting result{on, to_double(room), {}};
    result.at[along_x] = place[along_x];
    result.at[along_y] = place[along_y];
    std::optional<Point> direction;
    const bool still = is_across(a, direction) && is_across(b, direction);
    result.still[along_x] = result.still[along_y] = still;
    return result;
  }
  return std::nullopt;
}

}  // namespace

template <class K>
std::optional<ExactMeeting> exact_meeting(const ExactPatch<K>& x, const ExactPatch<K>& y, const Vec4& place,
                                          const Vec4& on) {
  if (auto simple = meeting_in_simple_numbers<K>(x, y, place, on)) return simple;
  return meeting_in_plane<K>(x, y, place, on);
}

#define EXSECT_INSTANTIATE(K)                                                                       \
  template std::optional<ExactMeeting> exact_meeting<K>(const ExactPatch<K>&, const ExactPatch<K>&, \
                                                        const Vec4&, const Vec4&);
EXSECT_INSTANTIATE(Bicubic)
EXSECT_INSTANTIATE(WeightedBiquadratic)
EXSECT_INSTANTIATE(WeightedBicubic)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
