#include "certificate/search.h"

#include <exsect/checker/factors.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace exsect::cli {
namespace {

using checker::Matrix3;
using checker::others;

double largest(const Matrix3<double>& m) {
  double most = 0;
  for (const auto& row : m)
    for (const double a : row) most = std::max(most, std::abs(a));
  return most;
}

/// a rounded to a multiple of 2^-bits.
double rounded(double a, int bits) { return std::ldexp(std::nearbyint(std::ldexp(a, bits)), -bits); }

/// w_axis held: w - C F(w).
Parameters newton_step(const Map& map, Parameters w, std::size_t axis) {
  const Map local = map.at(w);
  const auto c = inverse(local, axis);
  if (!c) throw NoCertificate("a point where Newton's method fails");
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t d = 0; d < 3; ++d) w[others(axis)[i]] -= (*c)[i][d] * local.value(d);
  return w;
}

/// Every condition of the check, with a margin for rounding.
bool holds(const Tube& tube, const Equation& equation, const Map& local, Turns turns) {
  for (const double slack : checker::contraction(tube, local))
    if (!(slack > 0.05 * tube.width)) return false;
  const Parameters extent = tube.extent();
  const auto bounds = checker::curve_bounds(local, tube.axis, extent);
  if (tube.chart != Chart::pair)
    return checker::monotone_pairs(tube, bounds, rounding_margin * (tube.centre[3] + tube.reach));
  const auto constant = factored(equation, tube);
  if (!constant) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool inside = tube.centre[i] >= extent[i] && tube.centre[i] + extent[i] <= 1;
    const bool may_turn = inside && (turns == Turns::often || definite(bounds.second[i]));
    if (!(*constant)[i] && !definite(bounds.first[i]) && !may_turn) return false;
  }
  return true;
}

}  // namespace

std::optional<std::array<bool, 4>> factored(const Equation& equation, const Tube& tube) {
  if (!equation.factor) return equation.constant;
  checker::Box<double> box;
  const Parameters extent = tube.extent();
  for (std::size_t i = 0; i < 4; ++i) box[i] = {tube.centre[i], extent[i] * (1 + 0x1p-20)};
  const auto& [factor, map, columns, walls] = *equation.factor;
  if (!checker::independent<double>(columns, box) &&
      !(walls && checker::on_one_side<double>(factor, *walls, columns, box)))
    return std::nullopt;
  return checker::constant_in(factor.map, map, box);
}

bool definite(const checker::Ball<double>& b) {
  return std::abs(b.middle) > rounding_margin * b.radius && std::abs(b.middle) > 1e-11;
}

std::optional<Matrix3<double>> inverse(const Map& local, std::size_t k) {
  const auto o = others(k);
  const std::array<Vector, 3> c = {local.slope(o[0]), local.slope(o[1]), local.slope(o[2])};
  const double det = checker::dot(c[0], checker::cross(c[1], c[2]));
  if (!std::isfinite(1 / det)) return std::nullopt;
  Matrix3<double> m;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& a = c[(i + 1) % 3];
    const Vector& b = c[(i + 2) % 3];
    for (std::size_t d = 0; d < 3; ++d)
      m[i][d] = (a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3]) / det;
  }
  return m;
}

double apart(const Parameters& a, const Parameters& b) {
  double most = 0;
  for (std::size_t i = 0; i < 4; ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

Parameters tangent(const Map& map, const Parameters& w) {
  const Map local = map.at(w);
  Parameters t;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto o = others(k);
    t[k] = (k % 2 == 0 ? 1 : -1) *
           checker::dot(local.slope(o[0]), checker::cross(local.slope(o[1]), local.slope(o[2])));
  }
  return t;
}

std::size_t best_axis(const Map& map, const Parameters& w) {
  const Parameters t = tangent(map, w);
  std::size_t k = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (std::abs(t[i]) > std::abs(t[k])) k = i;
  return k;
}

Parameters on_curve(const Map& map, Parameters w, std::size_t fixed) {
  for (int i = 0; i < 6; ++i) w = newton_step(map, w, fixed);
  return w;
}

Parameters turning_point(const Map& map, Parameters w, std::size_t axis, std::size_t i) {
  for (int n = 0; n < 8; ++n) {
    const Map local = map.at(w);
    const auto c = inverse(local, axis);
    if (!c) throw NoCertificate("a turning point where Newton's method fails");
    const auto bounds = checker::curve_bounds(local.times(*c), axis, {});
    const double step = -bounds.first[i].middle / bounds.second[i].middle;
    if (!std::isfinite(step)) throw NoCertificate("a turning point of higher order");
    for (std::size_t j = 0; j < 4; ++j) w[j] += step * bounds.first[j].middle;
    w = newton_step(map, newton_step(map, w, axis), axis);
  }
  return w;
}

Tube tube_at(const Equation& equation, const Parameters& w, std::size_t axis, Turns turns, double limit) {
  const auto& [map, chart, number, factor, constant] = equation;
  const Map here = map.at(w);
  auto c = inverse(here, axis);
  if (!c) throw NoCertificate("a point where the patches touch");
  // Short numbers, but C DF is to be 1 to 12 bits.
  double steps = 1;
  for (std::size_t j = 0; j < 4; ++j)
    for (const double a : here.slope(j)) steps = std::max(steps, std::abs(a));
  const int more = std::max(0, std::ilogb(steps * largest(*c)));
  for (auto& row : *c)
    for (double& a : row) a = rounded(a, 12 + std::ilogb(steps) + 1);
  const auto slope = checker::curve_bounds(here.times(*c), axis, {}).first;
  double steepest = 1;
  for (const auto& b : slope) steepest = std::max(steepest, std::abs(b.middle));
  const int flat = std::ilogb(steepest);
  // The curve runs through the middle of a cube, but for the places of the centre's last bits.
  const auto tube_of = [&](double size) {
    Tube tube = {{chart}, w, axis, {}, std::ldexp(size, -flat), size, *c, number};
    for (std::size_t i = 0; i < 4; ++i) tube.slope[i] = i == axis ? 1 : rounded(slope[i].middle, 10);
    return tube;
  };
  const Map near = here.times(*c);
  const auto found = [&](Tube& tube) {
    if (!holds(tube, equation, near, turns)) return false;
    for (double& at : tube.centre) at = rounded(at, 12 + more - std::ilogb(tube.width));
    // m of the cuspidal point is that of the middle line.
    if (chart != Chart::pair) tube.centre = {tube.centre[0], tube.centre[1], w[2], 0};
    return holds(tube, equation, map.at(tube.centre).times(*c), turns);
  };
  for (double size = limit / 2; size > 0x1p-46; size /= 2) {
    Tube tube = tube_of(size);
    if (!found(tube)) continue;
    for (const double larger : {1.75, 1.5, 1.25}) {
      Tube other = tube_of(larger * size);
      if (found(other)) return other;
    }
    return tube;
  }
  throw NoCertificate("a point where no tube was found");
}

checker::CurveBounds<double> bounds_in(const Map& map, const Tube& tube) {
  return checker::curve_bounds(map.at(tube.centre).times(tube.inverse), tube.axis, tube.extent());
}

checker::Map<checker::Enclosure> in_enclosures(const Map& map) {
  checker::Map<checker::Enclosure> result;
  for (const auto& term : map.terms())
    result.coefficient(term.power) = {checker::Enclosure(term.c[0]), checker::Enclosure(term.c[1]),
                                      checker::Enclosure(term.c[2])};
  return result;
}

namespace {

// The errors of the check in doubles count, and are computed as it does.

checker::Vector4<checker::Enclosure> place_in_enclosures(const Parameters& w) {
  checker::Vector4<checker::Enclosure> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = checker::Enclosure(w[i]);
  return result;
}

/// At least |C F(w)|, component by component, in the check.
double checked_distance(const Map& map, const Tube& tube, const Parameters& w) {
  const checker::Vector3<checker::Enclosure> f = in_enclosures(map).value(place_in_enclosures(w));
  checker::Enclosure most = 0;
  for (const auto& row : tube.inverse) {
    checker::Vector3<checker::Enclosure> c;
    for (std::size_t d = 0; d < 3; ++d) c[d] = checker::Enclosure(row[d]);
    most = larger(most, magnitude(checker::dot(c, f)));
  }
  return 2 * most.above();  // coefficients are rounded there
}

}  // namespace

checker::Box<double> tangent_near(const Map& map, const Parameters& w, double near) {
  const checker::Enclosure h(near);
  const auto t = checker::tangent(in_enclosures(map).at(place_in_enclosures(w)), {h, h, h, h});
  checker::Box<double> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const double middle = approximate(t[i].middle);
    result[i] = {middle, 2 * (t[i].magnitude().above() - std::abs(middle))};
  }
  return result;
}

double distance(const Map& map, const Tube& tube, const Parameters& w) {
  return checked_distance(map, tube, w) / (1 - bounds_in(map, tube).defect);
}

Parameters pair_of(Chart chart, const Parameters& z, int side) {
  const double t = side * std::sqrt(z[3]);
  const double m = z[2] * t;
  return chart == Chart::first ? Parameters{z[0] + t, z[1] + m, z[0] - t, z[1] - m}
                               : Parameters{z[1] + m, z[0] + t, z[1] - m, z[0] - t};
}

Parameters in_chart(Chart chart, const Parameters& w) {
  const std::size_t p = chart == Chart::first ? 0 : 1;
  const double t = (w[p] - w[p + 2]) / 2;
  return {(w[p] + w[p + 2]) / 2, (w[1 - p] + w[3 - p]) / 2, (w[1 - p] - w[3 - p]) / (2 * t), t * t};
}

}  // namespace exsect::cli
