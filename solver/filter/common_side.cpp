#include "filter/common_side.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "filter/homogeneous.h"

namespace exsect::filter {

namespace {

using exsect::operator+;
using exsect::operator-;
using exsect::operator*;
using exsect::cross;
using exsect::dot;
using filter::operator+;
using filter::operator-;
using filter::operator*;
using filter::cross;
using filter::dot;

/// n over k.
constexpr int binomial(std::size_t n, std::size_t k) {
  int result = 1;
  for (std::size_t i = 1; i <= k; ++i) result = result * static_cast<int>(n + 1 - i) / static_cast<int>(i);
  return result;
}

/// The Bernstein coefficients, coefficient k times (3n-1 over k), of det(C, x_across, y_across) along a
/// common side: degree 3n-1.
template <class K, class Number, class Vector>
std::array<Number, 3 * K::degree> tangent_along(const std::array<Vector, K::degree>& direction,
                                                const std::array<Vector, K::side>& x,
                                                const std::array<Vector, K::side>& y) {
  constexpr std::size_t n = K::degree;
  std::array<Number, 3 * n> sum;
  sum.fill(Number(0));
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      const Vector normal = cross(x[i], y[j]);
      for (std::size_t k = 0; k < n; ++k) {
        sum[i + j + k] +=
            Number(binomial(n, i) * binomial(n, j) * binomial(n - 1, k)) * dot(direction[k], normal);
      }
    }
  }
  return sum;
}

template <class Number>
Number as(const Rational& q) {
  if constexpr (std::is_same_v<Number, double>) {
    return to_double(q);
  } else {
    return q;
  }
}

/// Control vectors on the interval: the blossom.
template <class Number, class Vector, std::size_t Count>
std::array<Vector, Count> on_interval(const std::array<Vector, Count>& c, const std::array<Number, 2>& to) {
  std::array<Vector, Count> result;
  for (std::size_t k = 0; k < Count; ++k) {
    std::array<Vector, Count> p = c;
    for (std::size_t level = 1; level < Count; ++level) {
      const Number& t = level + k < Count ? to[0] : to[1];
      for (std::size_t i = 0; i + level < Count; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
    }
    result[k] = p[0];
  }
  return result;
}

/// (14.15) of polynomial patches, on the part that both sides have in common.
template <class K, class Number, class Vector, class Net>
std::array<Number, 3 * K::degree> tangents(const Net& x, const Net& y, const SideContactOf<K>& side) {
  std::array<Vector, K::degree> direction;
  std::array<Vector, K::side> across_x;
  std::array<Vector, K::side> across_y;
  for (std::size_t j = 0; j < K::side; ++j) {
    across_x[j] = step_between(x, side.x.index(1, j), side.x.index(0, j));
    across_y[j] = step_between(y, side.y.index(1, j), side.y.index(0, j));
    if (j < K::degree) {
      direction[j] = step_between(x, side.x.index(0, j + 1), side.x.index(0, j));
    }
  }
  if (side.path) {
    const auto [on_x, on_y] = common_part<K>(side, *side.path);
    const std::array<Number, 2> t = {as<Number>(on_x[0]), as<Number>(on_x[1])};
    direction = on_interval(direction, t);
    across_x = on_interval(across_x, t);
    across_y = on_interval(across_y, std::array<Number, 2>{as<Number>(on_y[0]), as<Number>(on_y[1])});
  }
  return tangent_along<K, Number>(direction, across_x, across_y);
}

/// Tangential if (14.15) vanishes all along the side; exactly, where doubles do not tell, as on nearly
/// smooth edges. The weights in the sums of `tangent_along` add up to
/// (3n-1 over k).
template <class K>
requires(!K::weighted) Contact touches_along(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                             const PairOf<K>& pair, const SideContactOf<K>& side) {
  if (K::degree == 2 || !side.path) {
    const double error = (side.path ? kPartDeterminantError : kDeterminantError) * pair.net_error;
    const auto rounded = tangents<K, double, Vec3>(pair.x, pair.y, side);
    for (std::size_t k = 0; k < rounded.size(); ++k) {
      if (std::fabs(rounded[k]) > error * binomial(3 * K::degree - 1, k)) {
        return Contact::transversal;
      }
    }
  }
  const auto exact = tangents<K, Rational, Point>(x, y, side);
  const bool touch = std::all_of(exact.begin(), exact.end(), [](const Rational& t) { return t == 0; });
  return touch ? Contact::tangential : Contact::transversal;
}

template <class K>
FirstOrder<K> first_order(const ExactPatch<K>& patch, const SideView& view, const Rational& t) {
  const Rational along = view.reversed ? Rational(1 - t) : t;
  const Rational across = view.side.upper ? 1 : 0;
  return view.side.parameter == 0 ? FirstOrder<K>(patch, across, along) : FirstOrder<K>(patch, along, across);
}

/// [C C' X^ Y^] has degree 4n-2 along the side: tangential if it is zero at so many points and one more of
/// the common part, as beyond it a point of x may be at no finite parameter of y.
template <class K>
requires K::weighted Contact touches_along(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>&,
                                           const SideContactOf<K>& side) {
  const int count = 4 * static_cast<int>(K::degree) - 1;
  const std::array<Rational, 2> ends =
      side.path ? common_part<K>(side, *side.path)[0] : std::array<Rational, 2>{0, 1};
  for (int i = 0; i < count; ++i) {
    const Rational t = ends[0] + (ends[1] - ends[0]) * Rational(2 * i + 1, 2 * count);
    const auto a = first_order<K>(x, side.x, t);
    const auto b = first_order<K>(y, side.y, inverse(side.to_x, t));
    const std::size_t across_x = side.x.side.parameter;
    if (filter::determinant(a.value, a.derivative[1 - across_x], a.derivative[across_x],
                            b.derivative[side.y.side.parameter]) != 0) {
      return Contact::transversal;
    }
  }
  return Contact::tangential;
}

}  // namespace

Rational inverse(const MoebiusMap<Rational>& map, const Rational& t) {
  const Rational from_lower = t * map.weight[0] - map.value[0];
  const Rational to_upper = map.value[1] - t * map.weight[1];
  return from_lower / (from_lower + to_upper);
}

template <class K>
CommonPart common_part(const SideContactOf<K>& side, const SidePath& path) {
  std::array<std::array<Rational, 4>, 2> ends = {path.at(path.common.lower), path.at(path.common.upper)};
  const std::size_t along_x = 1 - side.x.side.parameter;
  const std::size_t along_y = 3 - side.y.side.parameter;
  if (ends[1][along_x] < ends[0][along_x]) {
    std::swap(ends[0], ends[1]);
  }
  const auto on_y = [&](const Rational& t) { return side.y.reversed ? 1 - t : t; };
  return {{{ends[0][along_x], ends[1][along_x]}, {on_y(ends[0][along_y]), on_y(ends[1][along_y])}}};
}

template <class K>
std::array<std::array<Rational, 4>, 2> ends_of_part(const SideContactOf<K>& side, const SidePath& path) {
  const CommonPart part = common_part<K>(side, path);
  std::array<std::array<Rational, 4>, 2> ends;
  for (std::size_t end = 0; end < 2; ++end)
    for (std::size_t i = 0; i < 2; ++i) {
      const SideView& view = i == 0 ? side.x : side.y;
      ends[end][2 * i + view.side.parameter] = view.side.upper ? 1 : 0;
      ends[end][2 * i + 1 - view.side.parameter] = view.reversed ? Rational(1 - part[i][end]) : part[i][end];
    }
  return ends;
}

template <class K>
Contact contact_along(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                      const SideContactOf<K>& side) {
  return touches_along<K>(x, y, pair, side);
}

#define EXSECT_INSTANTIATE(K)                                                                     \
  template Contact contact_along<K>(const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&, \
                                    const SideContactOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE
#define EXSECT_INSTANTIATE(K)                                                   \
  template CommonPart common_part<K>(const SideContactOf<K>&, const SidePath&); \
  template std::array<std::array<Rational, 4>, 2> ends_of_part<K>(const SideContactOf<K>&, const SidePath&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
