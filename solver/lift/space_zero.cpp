#include "lift/space_zero.h"

#include <exsect/algebra/ball.h>
#include <exsect/algebra/double_matrix.h>
#include <exsect/algebra/interruption.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "lift/local_polynomial.h"

namespace exsect {
namespace {

/// The three polynomials about a point, and about the inverse of their gradients there: 0, with which nothing
/// is proved, if there is none.
struct LocalSystem {
  std::array<LocalPolynomial, 3> forms;
  Matrix3 inverse;

  LocalSystem(const SpaceSystem& system, const Point& centre)
      : forms{LocalPolynomial(system[0], centre), LocalPolynomial(system[1], centre),
              LocalPolynomial(system[2], centre)} {
    std::array<Row3, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) {
      const SpaceBalls gradient = forms[i].gradient();
      for (std::size_t k = 0; k < 3; ++k) columns[k][i] = gradient[k].approximation();
    }
    inverse = approximate_inverse(columns).value_or(Matrix3{});
  }

  Row3 newton_step() const {
    Row3 step{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) step[k] -= inverse[k][i] * forms[i].value().approximation();
    return step;
  }

  /// (5.2), (5.3) without a parameter, on the cube.
  bool has_one_zero_within(double radius) const {
    const SpaceBalls cube = {DoubleBall(0, radius), DoubleBall(0, radius), DoubleBall(0, radius)};
    std::array<SpaceBalls, 3> gradients;
    for (std::size_t i = 0; i < 3; ++i) gradients[i] = forms[i].gradient_on(cube);
    for (std::size_t k = 0; k < 3; ++k) {
      DoubleBall moved;
      double spread = 0;
      for (std::size_t i = 0; i < 3; ++i) moved += DoubleBall(inverse[k][i]) * forms[i].value();
      for (std::size_t column = 0; column < 3; ++column) {
        DoubleBall entry(k == column ? -1 : 0);
        for (std::size_t i = 0; i < 3; ++i) entry += DoubleBall(inverse[k][i]) * gradients[i][column];
        spread += entry.upper_magnitude();
      }
      if (!((moved.upper_magnitude() + spread * radius) * kSlack + kUnderflowLoss < radius)) return false;
    }
    return true;
  }
};

/// Of the gradients, exactly: where surfaces nearly touch, products cancel.
SpacePolynomial determinant_of(const SpaceSystem& system) {
  std::array<std::array<SpacePolynomial, 3>, 3> g;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) g[i][k] = system[i].derivative(k);
  SpacePolynomial sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
    sum += g[2][k] * (g[0][next] * g[1][last] - g[0][last] * g[1][next]);
  }
  return sum;
}

/// A multiple of 2^-12 of the radius next to it.
Rational on_grid(const Rational& q, const Rational& unit) {
  const Rational scaled = q / unit;
  return Rational(Integer(numerator(scaled) / denominator(scaled))) * unit;
}

}  // namespace

std::optional<SpaceZero> space_zero(const SpaceSystem& system, Point guess, double radius) {
  constexpr int most_steps = 60;
  const Rational unit = power_of_two(std::ilogb(radius) - 12);
  for (int step = 0; step < most_steps; ++step) {
    interruption_point();
    for (Rational& coordinate : guess) coordinate = on_grid(coordinate, unit);
    const LocalSystem local(system, guess);
    const Row3 move = local.newton_step();
    const double size = std::max({std::fabs(move[0]), std::fabs(move[1]), std::fabs(move[2])});
    if (!std::isfinite(size) || !std::isfinite(move[0] + move[1] + move[2])) return std::nullopt;
    if (size < radius / 4 && local.has_one_zero_within(radius)) return SpaceZero{guess, radius};
    if (size < radius * 0x1p-10) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) guess[k] += from_double(move[k]);
  }
  return std::nullopt;
}

std::array<RationalInterval, 3> cube_of(const SpaceZero& zero) {
  std::array<RationalInterval, 3> cube;
  const Rational radius = from_double(zero.radius);
  for (std::size_t k = 0; k < 3; ++k) cube[k] = {zero.centre[k] - radius, zero.centre[k] + radius};
  return cube;
}

int sign_on(const SpacePolynomial& f, const SpaceZero& zero) {
  if (f.is_zero()) return 0;
  const DoubleBall reach(0, zero.radius);
  return LocalPolynomial(f, zero.centre).value_on({reach, reach, reach}).certain_sign();
}

int orientation_on(const SpaceSystem& system, const SpaceZero& zero) {
  const DoubleBall reach(0, zero.radius);
  std::array<SpaceBalls, 3> g;
  for (std::size_t i = 0; i < 3; ++i)
    g[i] = LocalPolynomial(system[i], zero.centre).gradient_on({reach, reach, reach});
  const DoubleBall determinant = g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) +
                                 g[0][1] * (g[1][2] * g[2][0] - g[1][0] * g[2][2]) +
                                 g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]);
  if (const int sign = determinant.certain_sign(); sign != 0) return sign;
  return sign_on(determinant_of(system), zero);
}

}  // namespace exsect
