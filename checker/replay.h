// What all parts of the check use: the maps, tubes that are proved, places in them. Internal to checker/. N
// is Rational, or Enclosure: then what is proved is proved, and what is not may nevertheless be true.
#pragma once

#include <algorithm>

#include "certificate.h"

namespace exsect::checker {

inline std::string place(const char* list, std::size_t i) {
  return std::string("$.") + list + "[" + std::to_string(i) + "]";
}
inline void require(bool holds, const std::string& place, const char* reason) {
  if (!holds) throw Rejected(place, reason);
}
/// list[i]; rejected at `place` if there is none.
template <class T>
const T& element(const std::vector<T>& list, std::size_t i, const std::string& place, const char* reason) {
  require(i < list.size(), place, reason);
  return list[i];
}

/// A line in the variables of a map, as polynomials of degree <= 2 in that of its axis, the constant
/// coefficient first.
template <class N>
using OnAxis = std::array<Vector3<N>, 4>;

/// A tube that is proved to hold one curve, with the derivatives on it.
template <class N>
struct ProvedTube {
  const Tube<N>& claim;
  CurveBounds<N> bounds;
  std::array<bool, 4> constant;    // parameters that are constant on the curve
  std::array<int, 4> grows;        // in a star: the signs of all others' derivatives
  std::optional<OnAxis<N>> exact;  // the curve, if it is a line
};

/// The map of each of the eight charts of a star, and the point of space.
template <class N>
struct StarMaps {
  std::array<Map<N>, 8> equation;
  std::array<Map<N>, 8> space;
};

template <class N>
struct Replay {
  const Certificate<N>& certificate;
  std::array<Net<Rational>, 2> exact;  // x and y in the power basis
  Vector3<Rational> origin;
  std::array<Map<N>, 3> equation;  // F of each chart, all moved by -origin
  std::array<Map<N>, 3> space;     // the point of space
  std::vector<StarMaps<N>> stars;
  std::vector<StarMaps<N>> seams;
  std::vector<ProvedTube<N>> tubes;

  const Map<N>& map(const Tube<N>& tube) const {
    return tube.chart == Chart::star ? stars[tube.star].equation[tube.direction]
                                     : equation[static_cast<std::size_t>(tube.chart)];
  }
  const Map<N>& space_map(const Tube<N>& tube) const {
    return tube.chart == Chart::star ? stars[tube.star].space[tube.direction]
                                     : space[static_cast<std::size_t>(tube.chart)];
  }
};

template <class N>
Replay<N> start(const Certificate<N>& certificate) {
  Replay<N> result = {certificate, {}, certificate.patches[0].net()[1][1], {}, {}, {}, {}, {}};
  std::array<Net<N>, 2> moved;
  for (std::size_t n = 0; n < 2; ++n) {
    result.exact[n] = certificate.patches[n].power_basis();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t d = 0; d < 3; ++d)
          moved[n][i][j][d] =
              N(Rational(result.exact[n][i][j][d] - (i + j == 0 ? result.origin[d] : Rational(0))));
  }
  result.equation[0] = pair_map(moved[0], moved[1]);
  add_patch(result.space[0], moved[0], N(1), 0);
  for (std::size_t chart = 1; certificate.self && chart < 3; ++chart) {
    result.equation[chart] = chart_map(moved[0]);
    result.space[chart] = chart_space(moved[0]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < i; ++j) std::swap(moved[0][i][j], moved[0][j][i]);
  }
  return result;
}

/// F at the place, exactly.
inline bool is_zero_at(const std::array<Net<Rational>, 2>& exact, const Vector4<Rational>& w) {
  return pair_map(exact[0], exact[1]).value(w) == Vector3<Rational>{};
}
template <class N>
Vector4<N> middles(const Box<N>& box) {
  return {box[0].middle, box[1].middle, box[2].middle, box[3].middle};
}
template <class N>
Box<N> ball(const Vector4<N>& at, const N& radius) {
  return {{{at[0], radius}, {at[1], radius}, {at[2], radius}, {at[3], radius}}};
}

/// q rounded up to a multiple of 2^-128: short numbers.
inline Rational rounded_up(const Rational& q) {
  const Integer scaled = numerator(q) << 128;
  Integer quotient;
  Integer remainder;
  divide_qr(scaled, denominator(q), quotient, remainder);
  return Rational(remainder > 0 ? quotient + 1 : quotient) * power_of_two(-128);
}
inline Enclosure rounded_up(const Enclosure& a) { return a; }

/// At least the square root, by less than 2^-60 of it.
inline Rational root_above(const Rational& q) {
  if (q <= 0) return 0;
  const auto bits = [](const Integer& n) { return n == 0 ? 0 : static_cast<long>(msb(n)) + 1; };
  const long shift = std::max(0L, 64 - (bits(numerator(q)) - bits(denominator(q))) / 2);
  const Integer scaled = (numerator(q) << (2 * static_cast<unsigned long>(shift))) / denominator(q) + 1;
  return Rational(sqrt(scaled) + 1) * power_of_two(-shift);
}

/// a_0 + a_1 t + a_2 t^2
template <class N>
N value(const Vector3<N>& a, const N& t) {
  return a[0] + t * (a[1] + t * a[2]);
}

/// The largest distance in a variable between `at` and the line's point with the same variable of the axis.
template <class N>
N distance_to_line(const ProvedTube<N>& tube, const Vector4<N>& at) {
  N most = 0;
  for (std::size_t i = 0; i < 4; ++i)
    most = larger(most, magnitude(N(at[i] - value((*tube.exact)[i], at[tube.claim.axis]))));
  return rounded_up(most);
}

/// Distance in each variable between `at`, which is in the tube, and the curve's point with the same variable
/// of the axis: at most |C F(at)| / (1 - defect), or exactly that of a line. Rejected at `where` if `at` is
/// not in the tube.
template <class N>
N distance(const Replay<N>& replay, const ProvedTube<N>& tube, const Vector4<N>& at,
           const std::string& where) {
  require(tube.claim.contains(ball(at, N(0))), where, "a point is not in its tube");
  if (tube.exact) return distance_to_line(tube, at);
  N most = 0;
  const Vector3<N> f = replay.map(tube.claim).value(at);
  for (const Vector3<N>& row : tube.claim.inverse) most = larger(most, magnitude(dot(row, f)));
  return rounded_up(most / (1 - tube.bounds.defect));
}

}  // namespace exsect::checker
