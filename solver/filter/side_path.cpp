#include "filter/side_path.h"

#include <algorithm>
#include <cmath>

#include "filter/common_normal.h"
#include "filter/homogeneous.h"
#include "filter/place_on_patch.h"
#include "filter/tube_newton.h"

namespace exsect::filter {

namespace {

using exsect::operator+;
using exsect::operator-;
using exsect::operator*;
using exsect::cross;
using filter::operator+;
using filter::operator-;
using filter::operator*;
using filter::cross;

using ExactPlace = std::array<Rational, 2>;

/// After each of Newton's steps, in exact arithmetic, how many bits are right, as a rule, at least.
constexpr std::array<long, 4> kRightBits = {40, 68, 130, 250};

/// q below |q| 2^bits, cut off.
Rational cut(const Rational& q, long bits) {
  const Rational scaled = q * power_of_two(bits);
  return Rational(Integer(numerator(scaled) / denominator(scaled))) * power_of_two(-bits);
}

ExactPlace between(const ExactPlace& a, const ExactPlace& b, const Rational& t) {
  return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1]};
}

/// Homogeneous coordinates of a patch, and 1/n of its derivatives.
struct ExactOrder {
  HomogeneousPoint value;
  std::array<HomogeneousPoint, 2> derivative;
};
ExactOrder exact_first_order(const BezierPatch& patch, const ExactPlace& at) {
  const auto vector = [](const Point& p, long factor, long weight) {
    return HomogeneousPoint{p[0] / factor, p[1] / factor, p[2] / factor, weight};
  };
  return {vector(patch(at[0], at[1]), 1, 1),
          {vector(patch.derivative_first(at[0], at[1]), 2, 0),
           vector(patch.derivative_second(at[0], at[1]), 2, 0)}};
}
template <class K>
ExactOrder exact_first_order(const ElevatedPatch<K>& patch, const ExactPlace& at) {
  const FirstOrder<K> order(patch, at[0], at[1]);
  return {order.value, order.derivative};
}

HomogeneousPoint exact_control_vector(const BezierPatch& patch, std::size_t i) {
  const Point& p = control_point(patch, i);
  return {p[0], p[1], p[2], 1};
}
template <class K>
HomogeneousPoint exact_control_vector(const ElevatedPatch<K>& patch, std::size_t i) {
  return homogeneous<K>(patch, i);
}

/// Also if one is zero, or both are at infinity.
bool are_parallel(const HomogeneousPoint& a, const HomogeneousPoint& b) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (minor(a, b, i, j) != 0) return false;
  return true;
}

/// Of a point with a positive weight.
Point affine_point(const HomogeneousPoint& p) { return {p[0] / p[3], p[1] / p[3], p[2] / p[3]}; }

/// The derivative in space, from the value and the derivative.
Vec3 affine_rate(const Vec3&, const Vec3& derivative) { return derivative; }
Vec3 affine_rate(const Vec4& value, const Vec4& derivative) {
  const Vec3 x = affine(value);
  return {(derivative[0] - x[0] * derivative[3]) / value[3],
          (derivative[1] - x[1] * derivative[3]) / value[3],
          (derivative[2] - x[2] * derivative[3]) / value[3]};
}

/// Means with (1-t) and t, one control point fewer each time.
template <class Vector, std::size_t Count, class Number>
std::array<Vector, Count - 1> curve_means(const std::array<Vector, Count>& c, const Number& t) {
  std::array<Vector, Count - 1> result;
  for (std::size_t k = 0; k + 1 < Count; ++k) result[k] = (1 - t) * c[k] + t * c[k + 1];
  return result;
}
/// The curve's point.
template <class Vector, std::size_t Count, class Number>
Vector curve_point(const std::array<Vector, Count>& c, const Number& t) {
  if constexpr (Count == 1) {
    return c[0];
  } else {
    return curve_point(curve_means(c, t), t);
  }
}

/// Ends, and the ratio of t on the line between them.
struct FoundPath {
  std::array<ExactPlace, 2> ends;
  Rational ratio;
};

template <class K>
class PathSearch {
 public:
  /// Of the line on which a parameter of the owner is `value`.
  PathSearch(const PatchOf<K>& owner, const PatchOf<K>& carrier, const ExactPatch<K>& exact_owner,
             const ExactPatch<K>& exact_carrier, std::size_t parameter, const Rational& value)
      : carrier_(carrier), exact_carrier_(exact_carrier) {
    const SideView view = {{parameter, false}, false, K::degree};
    for (std::size_t k = 0; k < K::side; ++k) {
      std::array<Row<K>, K::side> across;
      std::array<HomogeneousPoint, K::side> exact_across;
      for (std::size_t i = 0; i < K::side; ++i) {
        across[i] = owner.net[view.index(i, k)];
        exact_across[i] = exact_control_vector(exact_owner, view.index(i, k));
      }
      side_[k] = curve_point(across, to_double(value));
      exact_side_[k] = tangent_and_value(exact_across, value)[1];
    }
  }

  /// From a t, and a centred place nearby.
  std::optional<FoundPath> run(double t, Place near) const {
    std::array<Row<K>, K::degree> tangent;
    for (std::size_t k = 0; k < K::degree; ++k) {
      tangent[k] = static_cast<double>(K::degree) * (side_[k + 1] - side_[k]);
    }
    const Row<K> start = curve_point(side_, t);
    if (!improve_place(carrier_, near, affine(start))) {
      return std::nullopt;
    }
    const SecondOrder c = second_order(carrier_, near[0], near[1]);
    const Place rate = coordinates(c.u, c.v, affine_rate(start, curve_point(tangent, t)));
    std::array<ExactPlace, 2> ends;
    for (std::size_t i = 0; i < 2; ++i) {
      const double step = static_cast<double>(i) - t;
      Place end = {near[0] + step * rate[0], near[1] + step * rate[1]};
      const std::size_t corner = K::degree * i;
      if (!improve_place(carrier_, end, affine(side_[corner]))) {
        return std::nullopt;
      }
      const auto exact = exactly(end, exact_side_[corner]);
      if (!exact) {
        return std::nullopt;
      }
      ends[i] = *exact;
    }
    FoundPath path = {ends, 1};
    if (ends[0] == ends[1]) return std::nullopt;
    if (is_path(path)) return path;
    const auto ratio = ratio_between(ends);
    if (!ratio || *ratio == 1) return std::nullopt;
    path.ratio = *ratio;
    return is_path(path) ? std::optional(path) : std::nullopt;
  }

 private:
  /// From the place of the middle of the side. Requires different ends.
  std::optional<Rational> ratio_between(const std::array<ExactPlace, 2>& ends) const {
    const std::size_t i = ends[0][0] == ends[1][0] ? 1 : 0;
    const Rational half(1, 2);
    const ExactPlace middle = between(ends[0], ends[1], half);
    Place place = {to_double(middle[0] - half), to_double(middle[1] - half)};
    if (!improve_place(carrier_, place, affine(curve_point(side_, 0.5)))) return std::nullopt;
    const auto exact = exactly(place, tangent_and_value(exact_side_, half)[1]);
    if (!exact || (*exact)[i] == ends[1][i]) return std::nullopt;
    const Rational ratio = ((*exact)[i] - ends[0][i]) / (ends[1][i] - (*exact)[i]);
    return ratio > 0 ? std::optional(ratio) : std::nullopt;
  }

  /// The parameters of a point on the other patch near `guess`, centred: simple numbers, the numbers that one
  /// of Newton's steps leads to, as on a plane, or simple ones near these.
  std::optional<ExactPlace> exactly(const Place& guess, const HomogeneousPoint& point) const {
    const Rational half(1, 2);
    ExactPlace at = {from_double(guess[0]) + half, from_double(guess[1]) + half};
    for (const long bits : kRightBits) {
      const Rational room = power_of_two(-bits);
      const ExactPlace simple = {simplest_between(at[0] - room, at[0] + room),
                                 simplest_between(at[1] - room, at[1] + room)};
      for (const ExactPlace& candidate : {at, simple}) {
        const HomogeneousPoint value = exact_first_order(exact_carrier_, candidate).value;
        if (value[3] != 0 && are_parallel(value, point)) {
          return candidate;
        }
      }
      at = {cut(at[0], 2 * bits), cut(at[1], 2 * bits)};
      if (!step(at, point)) {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  /// In the two coordinates in which the tangent plane is projected best.
  bool step(ExactPlace& at, const HomogeneousPoint& point) const {
    const ExactOrder order = exact_first_order(exact_carrier_, at);
    if (order.value[3] == 0) return false;
    const Point now = affine_point(order.value);
    const auto derivative = [&](const HomogeneousPoint& d) {
      Point result;
      for (std::size_t k = 0; k < 3; ++k) {
        result[k] = static_cast<long>(K::degree) * (d[k] - now[k] * d[3]) / order.value[3];
      }
      return result;
    };
    const Point u = derivative(order.derivative[0]);
    const Point v = derivative(order.derivative[1]);
    const Point normal = cross(u, v);
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      k = abs(normal[i]) > abs(normal[k]) ? i : k;
    }
    if (normal[k] == 0) {
      return false;
    }
    const Point miss = affine_point(point) - now;
    at[0] += cross(miss, v)[k] / normal[k];
    at[1] += cross(u, miss)[k] / normal[k];
    return true;
  }

  /// A patch has degree 2 n along a line, or n where a parameter is constant, and products with the side have
  /// n more, if there are weights or a ratio: so many points decide, of which the ends are known.
  bool is_path(const FoundPath& path) const {
    const auto& [ends, ratio] = path;
    const bool along_parameter = ends[0][0] == ends[1][0] || ends[0][1] == ends[1][1];
    const int degree = static_cast<int>((along_parameter ? K::degree : 2 * K::degree) +
                                        (K::weighted || ratio != 1 ? K::degree : 0));
    for (int k = 1; k < degree; ++k) {
      const Rational t(k, degree);
      const ExactPlace at = between(ends[0], ends[1], along_path(ratio, t));
      if (!are_parallel(exact_first_order(exact_carrier_, at).value, tangent_and_value(exact_side_, t)[1])) {
        return false;
      }
    }
    return true;
  }

  const PatchOf<K>& carrier_;
  const ExactPatch<K>& exact_carrier_;
  std::array<Row<K>, K::side> side_;
  std::array<HomogeneousPoint, K::side> exact_side_;
};

/// The numbers of [0,1] along the line for which it is in the square; lower > upper if there are none.
RationalInterval common_part(const std::array<ExactPlace, 2>& ends) {
  RationalInterval common = {0, 1};
  for (std::size_t i = 0; i < 2; ++i) {
    const Rational& from = ends[0][i];
    const Rational rate = ends[1][i] - from;
    if (rate == 0) {
      if (from < 0 || from > 1) {
        return {1, 0};
      }
      continue;
    }
    const Rational at_0 = -from / rate;
    const Rational at_1 = (1 - from) / rate;
    common.lower = std::max(common.lower, std::min(at_0, at_1));
    common.upper = std::min(common.upper, std::max(at_0, at_1));
  }
  return common;
}

}  // namespace

std::array<Rational, 4> SidePath::at(const Rational& t) const {
  return LinePath{of_x, side.parameter, side.upper ? 1 : 0, ends, ratio, common}.at(t);
}

std::array<Rational, 4> LinePath::at(const Rational& t) const {
  const std::size_t own = of_x ? 0 : 2;
  const ExactPlace on_line = between(ends[0], ends[1], along_path(ratio, t));
  std::array<Rational, 4> result;
  result[own + parameter] = value;
  result[own + 1 - parameter] = t;
  result[2 - own] = on_line[0];
  result[3 - own] = on_line[1];
  return result;
}

template <class K>
std::optional<LinePath> line_path_near(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                                       std::size_t fixed, const Rational& value, const Vec4& near) {
  const bool of_x = fixed < 2;
  const PathSearch<K> search = of_x ? PathSearch<K>(pair.x, pair.y, x, y, fixed % 2, value)
                                    : PathSearch<K>(pair.y, pair.x, y, x, fixed % 2, value);
  const std::size_t other = of_x ? 2 : 0;
  const auto found = search.run(near[fixed ^ 1U] + 0.5, {near[other], near[other + 1]});
  if (!found) return std::nullopt;
  RationalInterval common = common_part(found->ends);
  if (!(common.lower < common.upper)) return std::nullopt;
  const Rational back = 1 / found->ratio;
  common = {along_path(back, common.lower), along_path(back, common.upper)};
  return LinePath{of_x, fixed % 2, value, found->ends, found->ratio, common};
}

template <class K>
std::optional<SidePath> side_path_near(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                                       std::size_t fixed, bool upper, const Vec4& near) {
  const auto path = line_path_near<K>(x, y, pair, fixed, upper ? 1 : 0, near);
  if (!path || (!K::weighted && path->ratio != 1)) return std::nullopt;
  return SidePath{path->of_x, {fixed % 2, upper}, path->ends, path->ratio, path->common};
}

#define EXSECT_INSTANTIATE(K)                                                                        \
  template std::optional<LinePath> line_path_near<K>(const ExactPatch<K>&, const ExactPatch<K>&,     \
                                                     const PairOf<K>&, std::size_t, const Rational&, \
                                                     const Vec4&);                                   \
  template std::optional<SidePath> side_path_near<K>(const ExactPatch<K>&, const ExactPatch<K>&,     \
                                                     const PairOf<K>&, std::size_t, bool, const Vec4&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
