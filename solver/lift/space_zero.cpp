#include "lift/space_zero.h"

#include <exsect/algebra/ball.h>
#include <exsect/algebra/interruption.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "lift/local_polynomial.h"

namespace exsect {
namespace {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<Vector3, 3>;

Vector3 cross_of(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// About the inverse of the matrix with these rows.
Matrix3 inverse_of(const Matrix3& rows) {
  const Matrix3 columns = {cross_of(rows[1], rows[2]), cross_of(rows[2], rows[0]),
                           cross_of(rows[0], rows[1])};
  const double determinant =
      rows[0][0] * columns[0][0] + rows[0][1] * columns[0][1] + rows[0][2] * columns[0][2];
  Matrix3 inverse;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) inverse[i][j] = columns[j][i] / determinant;
  return inverse;
}

/// The three polynomials about a point, and about the inverse of their gradients there.
struct LocalSystem {
  std::array<LocalPolynomial, 3> forms;
  Matrix3 inverse;

  LocalSystem(const SpaceSystem& system, const Point& centre)
      : forms{LocalPolynomial(system[0], centre), LocalPolynomial(system[1], centre),
              LocalPolynomial(system[2], centre)} {
    Matrix3 rows;
    for (std::size_t i = 0; i < 3; ++i) {
      const SpaceBalls gradient = forms[i].gradient();
      for (std::size_t k = 0; k < 3; ++k) rows[i][k] = gradient[k].approximation();
    }
    inverse = inverse_of(rows);
  }

  Vector3 newton_step() const {
    Vector3 step{};
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
    const Vector3 move = local.newton_step();
    const double size = std::max({std::fabs(move[0]), std::fabs(move[1]), std::fabs(move[2])});
    if (!std::isfinite(size) || !std::isfinite(move[0] + move[1] + move[2])) return std::nullopt;
    if (size < radius / 4 && local.has_one_zero_within(radius)) return SpaceZero{guess, radius};
    if (size < radius * 0x1p-10) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) guess[k] += from_double(move[k]);
  }
  return std::nullopt;
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
  return (g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) +
          g[0][1] * (g[1][2] * g[2][0] - g[1][0] * g[2][2]) +
          g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]))
      .certain_sign();
}

}  // namespace exsect
