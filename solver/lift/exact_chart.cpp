#include "lift/exact_chart.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>

#include "answer/parameter_box.h"
#include "curve/short_rational.h"

namespace exsect {
namespace {

/// All values of a polynomial of degree at most 2 on a closed interval.
RationalInterval range_of(const Polynomial& f, const RationalInterval& on) {
  const Rational a = f(on.lower), b = f(on.upper);
  RationalInterval range{std::min(a, b), std::max(a, b)};
  if (const Rational bend = f.coefficient(2); bend != 0) {
    const Rational vertex = -f.coefficient(1) / (2 * bend);
    if (on.lower < vertex && vertex < on.upper) range = hull(range, {f(vertex), f(vertex)});
  }
  return range;
}

/// Not above, not below the root of q >= 0, next to it by 2^-bits.
RationalInterval root_of(const Rational& q, long bits) {
  const Rational scaled = q * power_of_two(2 * bits);
  const Integer below = sqrt(Integer(numerator(scaled) / denominator(scaled)));
  const Rational unit = power_of_two(-bits);
  return {Rational(below) * unit, Rational(below + 1) * unit};
}

RationalInterval products(const RationalInterval& a, const RationalInterval& b) {
  const auto [least, most] = std::minmax({Rational(a.lower * b.lower), Rational(a.lower * b.upper),
                                          Rational(a.upper * b.lower), Rational(a.upper * b.upper)});
  return {least, most};
}

}  // namespace

ExactChart::ExactChart(const SurfaceChart& chart)
    : chart_(chart),
      radicand_in_u_(chart.radicand.at_s(0)),
      radicand_in_v_(chart.radicand.at_r(0) - Polynomial(chart.radicand.coefficient(0, 0))) {}

RationalInterval ExactChart::y_over(const RationalInterval& u, const RationalInterval& v, int sheet) const {
  if (sheet == 0) return {0, 0};
  const RationalInterval a = range_of(radicand_in_u_, u), b = range_of(radicand_in_v_, v);
  const Rational lower = std::max<Rational>(a.lower + b.lower, 0);
  const Rational upper = std::max<Rational>(a.upper + b.upper, 0);
  const RationalInterval roots = {root_of(lower, 100).lower, root_of(upper, 100).upper};
  return sheet > 0 ? roots : RationalInterval{-roots.upper, -roots.lower};
}

ExactChart::Place ExactChart::along_axes(const Place& at) const {
  if (chart_.is_affine()) return at;
  const RationalInterval below = range_of(chart_.denominator, at[0]);
  const RationalInterval width = quotients(range_of(chart_.width, at[0]), below);
  return {quotients(range_of(chart_.height, at[0]), below),
          products(width, {at[1].lower - chart_.middle, at[1].upper - chart_.middle}),
          products(width, at[2])};
}

SpaceBox ExactChart::in_space(const Place& along) const {
  SpaceBox box;
  const std::array<const Point*, 3> vectors = {&chart_.along_u, &chart_.along_v, &chart_.along_y};
  for (std::size_t k = 0; k < 3; ++k) {
    box[k] = {chart_.origin[k], chart_.origin[k]};
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational& rate = (*vectors[i])[k];
      const Rational a = rate * along[i].lower, b = rate * along[i].upper;
      box[k].lower += std::min(a, b);
      box[k].upper += std::max(a, b);
    }
  }
  return box;
}

double middle_of(const RationalInterval& at) { return to_double(at.midpoint()); }
double width_of(const RationalInterval& at) { return to_double(at.width()); }

double distance_from(const RationalInterval& at, double x) {
  const Rational place = from_double(x);
  return to_double(std::max<Rational>(at.upper - place, place - at.lower)) * kSlack + kUnderflowLoss;
}

}  // namespace exsect
