#include "certificate/near_nodes.h"

#include <algorithm>

#include "certificate/claims.h"
#include "certificate/long_point.h"

namespace exsect::cli {
namespace {

const ExactMap& exact_map(const Draft& d, const Tube& tube) {
  return tube.factor < 0 ? d.exact : d.factors.found()[static_cast<std::size_t>(tube.factor)].exact.map;
}

/// The curve's point with this value of the variable of the axis: each step of Newton's method, with an
/// inverse in doubles, finds some fifty binary digits.
Place long_curve_point(const ExactMap& map, Place w, std::size_t axis, int bits) {
  for (int found = 0; found < bits + 64; found += 32) {
    const ExactMap local = map.at(w);
    const checker::Matrix3<Rational> c = checker::near_inverse(local, axis);
    const Point f = {local.value(0), local.value(1), local.value(2)};
    for (std::size_t j = 0; j < 3; ++j) {
      Rational& q = w[checker::others(axis)[j]];
      q = in_bits(q - checker::dot(c[j], f), bits);
    }
  }
  return w;
}

/// The point where w_i' vanishes, i the first parameter that turns in the node, found likewise.
Place long_turning_point(const ExactMap& map, Place w, std::size_t axis, std::size_t i, int bits) {
  Parameters near;
  for (std::size_t j = 0; j < 4; ++j) near[j] = to_double(w[j]);
  const Map local = checker::rounded<double>(map).at(near);
  const auto c = inverse(local, axis);
  if (!c) throw NoCertificate("a turning point where Newton's method fails");
  const auto bounds = checker::curve_bounds(local.times(*c), axis, {});
  for (int found = 0; found < bits + 64; found += 24) {
    w = long_curve_point(map, w, axis, bits);
    const auto t = checker::tangent(map.at(w), {});
    const double second = bounds.second[i].middle;
    if (t[axis].middle == 0 || !std::isfinite(1 / second))
      throw NoCertificate("a turning point of higher order");
    const Rational step = -t[i].middle / t[axis].middle / from_double(second);
    for (std::size_t j = 0; j < 4; ++j) w[j] = in_bits(w[j] + step * t[j].middle / t[axis].middle, bits);
  }
  return long_curve_point(map, w, axis, bits);
}

LongPlace long_place(const Draft& d, const Node& n, const Tube& tube, int bits) {
  const ExactMap& map = exact_map(d, tube);
  Place w;
  for (std::size_t i = 0; i < 4; ++i) w[i] = in_bits(n.box[i].midpoint(), bits);
  for (const Side& side : n.on) w[index(side.parameter)] = side.value;
  w = n.on.empty() ? long_turning_point(map, w, tube.axis, index(n.wrt[0]), bits)
                   : long_curve_point(map, w, tube.axis, bits);
  for (const Side& side : n.on) w[index(side.parameter)] = side.value;
  return {w, power_of_two(-bits * 3 / 4), bits};
}

bool are_apart(const LongPlace& a, const LongPlace& b) {
  Rational most = 0;
  for (std::size_t i = 0; i < 4; ++i) most = std::max<Rational>(most, abs(a.at[i] - b.at[i]));
  return most > 256 * (a.radius + b.radius);
}

}  // namespace

std::vector<LongPlace> told_apart(const Draft& d, const std::vector<const Node*>& nodes,
                                  const std::vector<Tube>& tubes) {
  const auto is_chart = [](const Tube& tube) { return tube.chart != Chart::pair; };
  const bool charted = std::any_of(tubes.begin(), tubes.end(), is_chart);
  for (int bits = 128; bits <= 1024 && !charted; bits *= 2) {
    std::vector<LongPlace> result;
    for (std::size_t i = 0; i < nodes.size(); ++i) result.push_back(long_place(d, *nodes[i], tubes[i], bits));
    bool apart = true;
    for (std::size_t i = 0; i < result.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) apart = apart && are_apart(result[i], result[j]);
    if (apart) return result;
  }
  throw NoCertificate("nodes nearer to each other than doubles tell");
}

TracedArc short_arc(const Draft& d, const LongPlace& from, const LongPlace& to,
                    const std::array<std::size_t, 2>& tubes, std::size_t vertices) {
  const Tube& tube = d.tubes[tubes[0]];
  const int bits = std::max(from.bits, to.bits);
  Place middle;
  for (std::size_t i = 0; i < 4; ++i) middle[i] = in_bits((from.at[i] + to.at[i]) / 2, bits);
  middle = long_curve_point(exact_map(d, tube), middle, tube.axis, bits);
  TracedArc result;
  result.points = {{{}, 0}, {{}, -1, middle}, {{}, static_cast<int>(vertices) - 1}};
  result.pieces = {{tubes[0], 1}, {tubes[1], 2}};
  return result;
}

}  // namespace exsect::cli
