#include "lift/space_tube.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "lift/local_polynomial.h"

namespace exsect {
namespace {

/// The coordinates beside the axis, in a right-handed order.
std::array<std::size_t, 2> beside(std::size_t axis) { return {(axis + 1) % 3, (axis + 2) % 3}; }

/// Two equations about a chord, times about the inverse of their gradients across it.
struct ChordSystem {
  std::array<LocalPolynomial, 2> forms;
  std::array<std::size_t, 2> lateral;
  std::array<std::array<double, 2>, 2> inverse{};

  ChordSystem(const SpacePolynomial& f, const SpacePolynomial& g, const Point& centre, std::size_t axis)
      : forms{LocalPolynomial(f, centre), LocalPolynomial(g, centre)}, lateral(beside(axis)) {
    std::array<std::array<double, 2>, 2> a;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k) a[i][k] = forms[i].gradient()[lateral[k]].approximation();
    const double determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    inverse = {
        {{a[1][1] / determinant, -a[0][1] / determinant}, {-a[1][0] / determinant, a[0][0] / determinant}}};
  }

  /// Bounds f of (5.2), row by row.
  std::array<double, 2> offsets(const std::array<double, 3>& slope, double reach) const {
    const std::array<DoubleBall, 2> values = {values_along(forms[0].along(slope), reach),
                                              values_along(forms[1].along(slope), reach)};
    std::array<double, 2> result;
    for (std::size_t k = 0; k < 2; ++k)
      result[k] =
          (DoubleBall(inverse[k][0]) * values[0] + DoubleBall(inverse[k][1]) * values[1]).upper_magnitude();
    return result;
  }

  /// (5.3) on the box, for the bounds f.
  bool contracts(const std::array<SpaceBalls, 2>& gradients, const std::array<double, 2>& offset,
                 const std::array<double, 3>& width) const {
    for (std::size_t k = 0; k < 2; ++k) {
      double image = offset[k];
      for (std::size_t column = 0; column < 2; ++column) {
        const DoubleBall entry = DoubleBall(inverse[k][0]) * gradients[0][lateral[column]] +
                                 DoubleBall(inverse[k][1]) * gradients[1][lateral[column]] -
                                 DoubleBall(k == column ? 1 : 0);
        image += entry.upper_magnitude() * width[lateral[column]];
      }
      if (!(image * kSlack + kUnderflowLoss < width[lateral[k]])) return false;
    }
    return true;
  }
};

/// f - a g for a linear polynomial a, whose gradient across an axis is about orthogonal to that of g in a
/// point, and near it to first order: where surfaces nearly touch, what their gradients have in common
/// cancels exactly so, and not in balls. Has the same zeros as f where g = 0.
std::optional<SpacePolynomial> parted(const SpacePolynomial& f, const SpacePolynomial& g, const Point& centre,
                                      std::size_t axis) {
  const std::array<std::size_t, 2> lateral = beside(axis);
  std::array<double, 3> gradient{};
  for (std::size_t k = 0; k < 3; ++k) gradient[k] = to_double(g.derivative(k)(centre));
  const auto along_g = [&](const auto& vector) {
    return gradient[lateral[0]] * vector(lateral[0]) + gradient[lateral[1]] * vector(lateral[1]);
  };
  const double square = along_g([&](std::size_t i) { return gradient[i]; });
  const double common = along_g([&](std::size_t i) { return to_double(f.derivative(i)(centre)); }) / square;
  if (!std::isfinite(common)) return std::nullopt;
  SpacePolynomial a = SpacePolynomial::constant(from_double(common));
  // Of f - common g the product of both gradients across the axis changes by these rates, and by the gradient
  // of a, and that of g times a number, after subtraction of a g.
  const SpacePolynomial rest = f - a * g;
  std::array<double, 3> rates{};
  for (std::size_t k = 0; k < 3; ++k)
    rates[k] = along_g([&](std::size_t i) { return to_double(rest.derivative(i).derivative(k)(centre)); });
  const double shared = along_g([&](std::size_t i) { return rates[i]; }) / (2 * square);
  for (std::size_t k = 0; k < 3; ++k) {
    const double rate = (rates[k] - gradient[k] * shared) / square;
    if (!std::isfinite(rate)) return std::nullopt;
    a += from_double(rate) * (SpacePolynomial::variable(k) - SpacePolynomial::constant(centre[k]));
  }
  return f - a * g;
}

}  // namespace

std::optional<SpaceTube> SpaceTube::around(const SpacePolynomial& f, const SpacePolynomial& g,
                                           const Point& from, const Point& to) {
  if (std::optional<SpaceTube> tube = proved(f, g, from, to)) return tube;
  const Point chord = to - from;
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (abs(chord[axis]) < abs(chord[k])) axis = k;
  const std::optional<SpacePolynomial> other = parted(f, g, Rational(1, 2) * (from + to), axis);
  return other ? proved(*other, g, from, to) : std::nullopt;
}

std::optional<SpaceTube> SpaceTube::proved(const SpacePolynomial& f, const SpacePolynomial& g,
                                           const Point& from, const Point& to) {
  SpaceTube tube;
  std::array<double, 3> chord{};
  for (std::size_t k = 0; k < 3; ++k) {
    chord[k] = to_double(to[k] - from[k]);
    tube.centre_[k] = (from[k] + to[k]) / 2;
    if (std::fabs(chord[k]) > std::fabs(chord[tube.axis_])) tube.axis_ = k;
  }
  const double length = std::fabs(chord[tube.axis_]);
  for (std::size_t k = 0; k < 3; ++k) tube.slope_[k] = chord[k] / chord[tube.axis_];
  tube.slope_[tube.axis_] = 1;
  tube.reach_ = length * (0.5 + 0x1p-6);
  const ChordSystem system(f, g, tube.centre_, tube.axis_);
  const std::array<double, 2> offset = system.offsets(tube.slope_, tube.reach_);
  const double least = larger_bound(offset[0], offset[1]) / 4 + length * 0x1p-30;
  for (std::size_t k = 0; k < 2; ++k) tube.width_[system.lateral[k]] = 1.25 * offset[k] + least;
  const SpaceBalls beside = {DoubleBall(0, tube.width_[0]), DoubleBall(0, tube.width_[1]),
                             DoubleBall(0, tube.width_[2])};
  const std::array<SpaceBalls, 2> gradients = {
      system.forms[0].gradient_beside(tube.slope_, tube.reach_, beside),
      system.forms[1].gradient_beside(tube.slope_, tube.reach_, beside)};
  if (!system.contracts(gradients, offset, tube.width_)) return std::nullopt;
  const auto& [i, j] = system.lateral;
  tube.direction_ = (gradients[0][i] * gradients[1][j] - gradients[0][j] * gradients[1][i]).certain_sign();
  return tube.direction_ != 0 ? std::optional(tube) : std::nullopt;
}

/// s in the place of the axis, d in the others.
std::array<DoubleBall, 3> SpaceTube::offset(const Point& p, double radius) const {
  std::array<DoubleBall, 3> w;
  for (std::size_t k = 0; k < 3; ++k)
    w[k] = DoubleBall::enclosing(Rational(p[k] - centre_[k])).widened(radius);
  for (const std::size_t k : beside(axis_)) w[k] -= DoubleBall(slope_[k]) * w[axis_];
  return w;
}

SpaceTube::Place SpaceTube::place_of(const SpaceZero& zero) const {
  const std::array<DoubleBall, 3> at = offset(zero.centre, zero.radius);
  bool is_inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const double bound = k == axis_ ? reach_ : width_[k];
    if (at[k].lower_magnitude() > bound) return Place::outside;
    is_inside = is_inside && at[k].upper_magnitude() <= bound;
  }
  return is_inside ? Place::inside : Place::unknown;
}

int SpaceTube::order(const SpaceZero& first, const SpaceZero& second, int sense) const {
  const DoubleBall a = offset(first.centre, first.radius)[axis_],
                   b = offset(second.centre, second.radius)[axis_];
  return (a - b).certain_sign() * direction_ * sense;
}

double SpaceTube::distance_to_chord(const Point& from, const Point& to) const {
  const std::array<DoubleBall, 3> a = offset(from, 0), b = offset(to, 0);
  std::array<double, 3> off{};
  for (const std::size_t k : beside(axis_))
    off[k] = width_[k] + larger_bound(a[k].upper_magnitude(), b[k].upper_magnitude());
  return length_bound(off[0], off[1], off[2]) * kSlack;
}

}  // namespace exsect
