// What all parts of the check use: the maps, tubes that are proved, places in them. Internal to checker/. N
// is Rational, or Enclosure: then what is proved is proved, and what is not may nevertheless be true.
#pragma once

#include <algorithm>

#include "factors.h"
#include "pairs_of_points.h"
#include "position.h"
#include "section.h"
#include "walls.h"

namespace exsect::checker {

inline std::string place(const std::string& list, std::size_t i) {
  return list + "[" + std::to_string(i) + "]";
}
/// check(), which is rejected here if it fails: as a violation of this kind if it says no other one.
template <class Check>
auto replayed(const std::string& list, std::size_t i, const Check& check, Violation kind = Violation::claim) {
  try {
    return check();
  } catch (const Failed& failed) {
    throw Rejected(place(list, i), failed.what(), failed.kind == Violation::claim ? kind : failed.kind,
                   failed.needed);
  }
}

/// check(i) for each element.
template <class List, class Check>
void each(const std::string& name, const List& list, const Check& check, Violation kind = Violation::claim) {
  for (std::size_t i = 0; i < list.size(); ++i)
    replayed(
        name, i, [&] { check(i); }, kind);
}

/// A tube that is proved to hold one curve, with the derivatives on it.
template <class N>
struct ProvedTube {
  const Tube<N>& claim;
  Map<N> map;  // that vanishes on the curve
  CurveBounds<N> bounds = {};
  std::array<bool, 4> constant = {};  // parameters that are constant on the curve
  std::array<int, 4> grows = {};      // in a star: the signs of all others' derivatives
};

/// The coordinates of a star, and in each of its eight charts the map and the point of space.
template <class N>
struct StarMaps {
  Frame<N> frame;
  std::array<Map<N>, 8> equation;
  std::array<Position<N>, 8> space;
};

template <class N>
struct Replay {
  const Certificate<N>& certificate;
  Vector3<Rational> origin;
  Map<Rational> exact;                // F
  Position<Rational> exact_space;     // x, moved by -origin
  std::array<Polynomial, 2> weights;  // w_x and w_y; of an equation 1
  std::array<Map<N>, 3> equation;     // F of each chart
  std::array<Position<N>, 3> space;   // the point of space, moved by -origin
  std::array<Divided<N>, 2> divided;  // of both charts of one patch
  std::vector<bool> touching = {};    // of each factor: the patches touch along its curve
  std::vector<StarMaps<N>> stars;
  std::vector<ProvedTube<N>> tubes;
  std::vector<Shortfall>* shortfalls = nullptr;  // where they are listed instead of rejected

  /// check(), which fails if the error bound of this arc or edge is too small.
  template <class Check>
  void check_error_bound(std::optional<std::size_t> overlap, std::size_t arc, const Check& check) const {
    try {
      check();
    } catch (const Failed& failed) {
      if (!shortfalls || failed.kind != Violation::error_bound || !failed.needed) throw;
      shortfalls->push_back({overlap, arc, *failed.needed});
    }
  }
  /// Of the pair: what vanishes on the tube's curve.
  const Map<Rational>& exact_map(const Tube<N>& tube) const {
    return tube.factor < 0 ? exact : certificate.factors[static_cast<std::size_t>(tube.factor)].map;
  }
  const Position<N>& space_of(const Tube<N>& tube) const {
    return tube.chart == Chart::star ? stars[tube.star].space[tube.direction]
                                     : space[static_cast<std::size_t>(tube.chart)];
  }
};

/// The lower or upper half of a cell, exactly: its numbers are multiples of 2^-52.
inline Box<double> half_of(Box<double> box, std::size_t parameter, bool upper) {
  auto& [middle, half] = box[parameter];
  half /= 2;
  require(half >= 0x1p-51, "a half edge below 2^-51");
  middle += upper ? half : -half;
  return box;
}
template <class N>
Box<N> exactly(const Box<double>& box) {
  Box<N> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = {N(box[i].middle), N(box[i].radius)};
  return result;
}

template <class N>
Replay<N> start(const Certificate<N>& certificate) {
  const Net<Rational>& first = certificate.nets[0].points;
  const Vector3<Rational>& middle = first[first.degree(0) / 2][first.degree(1) / 2];
  Replay<N> result = {certificate, middle, {}, {}, {}, {}, {}, {}, {}, {}, {}};
  const auto& equation = certificate.equation;
  std::array<WeightedNet<Rational>, 2> power = certificate.nets;
  if (equation) {
    power[0].to_powers();
    result.exact = section_map(Section(*equation, power[0]).polynomial());
    power = certificate.nets;
  }
  for (WeightedNet<Rational>& c : power) {
    c.move_by_minus(result.origin);
    c.to_powers();
  }
  if (!equation) result.exact = pair_map(power[0], power[1]);
  result.exact_space = position_on(power[0]);
  for (const std::size_t n : {0, 1})
    result.weights[n] = polynomial_in(equation ? one<Rational>() : power[n].weights, 2 * n);
  result.equation[0] = rounded<N>(result.exact);
  result.space[0] = rounded<N>(result.exact_space);
  for (std::size_t n = 0; certificate.self && n < 2; ++n) {
    const PairChart<N> chart = rounded<N>(pair_chart(n == 0 ? power[0] : power[0].exchanged()));
    result.divided[n] = chart.divided;
    result.equation[n + 1] = chart.equation;
    result.space[n + 1] = chart.space;
  }
  return result;
}

/// F(w) = 0.
inline bool is_solution(const Map<Rational>& exact, const Vector4<Rational>& w) {
  return exact.value(w) == Vector3<Rational>{};
}

/// q > 0 rounded up to a multiple of 2^-128, or to 64 binary digits or more where it is less than 2^-64:
/// short numbers.
inline Rational rounded_up(const Rational& q) {
  if (q <= 0) return q;
  const long above_one = static_cast<long>(msb(numerator(q))) - static_cast<long>(msb(denominator(q)));
  const long bits = std::max(128L, 64 - above_one);
  const Rational scaled = q * power_of_two(bits);
  const Integer below = numerator(scaled) / denominator(scaled);  // towards 0
  return Rational(below < scaled ? below + 1 : below) * power_of_two(-bits);
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

/// Distance in each variable between `at`, which is in the tube, and the curve's point with the same variable
/// of the axis: at most |C F(at)| / (1 - defect).
template <class N>
N distance(const ProvedTube<N>& tube, const Vector4<N>& at) {
  require(tube.claim.contains(box_around(at, N(0))), "a point is not in its tube");
  N most = 0;
  const Vector3<N> f = tube.map.value(at);
  for (const Vector3<N>& row : tube.claim.inverse) most = larger(most, magnitude(dot(row, f)));
  return rounded_up(most / (1 - tube.bounds.defect));
}

}  // namespace exsect::checker
