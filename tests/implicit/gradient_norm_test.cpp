#include <exsect/implicit/gradient_norm.h>

#include <array>
#include <cmath>
#include <numbers>

#include "support/catch.h"

namespace exsect::gradient_norm_test {

namespace {

/// Example 8: f = 4 x^2 + 8 y^2 - 1 on [0,1] x [0,3/5].
BivariatePolynomial ellipse() {
  const BivariatePolynomial x = BivariatePolynomial::r(), y = BivariatePolynomial::s();
  return x * x * Polynomial(4) + y * y * Polynomial(8) - BivariatePolynomial::constant(1);
}

const PlanarBox region = {{Rational(0), Rational(1)}, {Rational(0), Rational(3, 5)}};

double at(const BivariatePolynomial& f, double x, double y) {
  return to_double(f(from_double(x), from_double(y)));
}

/// On the arc x = cos(a)/2, y = sin(a)/sqrt 8 of f = 0: where the relative error of h is below 2 %, as a part
/// of the angle a and as a part of the length, and the largest relative error.
struct ArcError {
  double part_of_angle;
  double part_of_length;
  double largest;
};

ArcError arc_error(const BivariatePolynomial& h) {
  constexpr int steps = 4000;
  double angles = 0, below = 0, length = 0, largest = 0;
  for (int k = 0; k <= steps; ++k) {
    const double angle = k * std::numbers::pi / 2 / steps;
    const double x = std::cos(angle) / 2, y = std::sin(angle) / std::sqrt(8.0);
    const double speed = std::hypot(std::sin(angle) / 2, std::cos(angle) / std::sqrt(8.0));
    const double error = std::abs(at(h, x, y) / (8 * std::sqrt(x * x + 4 * y * y)) - 1);
    length += speed;
    if (error < 0.02) below += speed;
    if (error < 0.02) ++angles;
    largest = std::max(largest, error);
  }
  return {angles / (steps + 1), below / length, largest};
}

}  // namespace

TEST_CASE("Example 8: the norm of the gradient of an ellipse", "[gradient_norm]") {
  struct Expected {
    Rational epsilon;
    std::array<double, 6> coefficients;  // of 1, x, y, x^2, xy, y^2
    double part_of_angle;
    double part_of_length;
    double largest;
  };
  const Expected expected[] = {
      {1000, {0.355084, 5.088516, 10.958897, 2.621280, -8.807402, 8.424604}, 0.4793, 0.4781, 0.11133},
      {Rational(1, 1000),
       {0.600690, 4.814199, 9.519758, 3.395948, -11.989747, 13.346446},
       0.9635,
       0.9703,
       0.03581}};
  for (const Expected& e : expected) {
    const BivariatePolynomial h = fitted_gradient_norm(ellipse(), region, 2, e.epsilon);
    const std::array<Rational, 6> c = {h.coefficient(0, 0), h.coefficient(1, 0), h.coefficient(0, 1),
                                       h.coefficient(2, 0), h.coefficient(1, 1), h.coefficient(0, 2)};
    for (std::size_t i = 0; i < 6; ++i) CHECK(std::abs(to_double(c[i]) - e.coefficients[i]) < 2e-5);
    const ArcError error = arc_error(h);
    CHECK(std::abs(error.part_of_angle - e.part_of_angle) < 1e-3);
    CHECK(std::abs(error.part_of_length - e.part_of_length) < 1e-3);
    CHECK(std::abs(error.largest - e.largest) < 1e-4);
  }
}

TEST_CASE("the norm of a constant gradient is found exactly", "[gradient_norm]") {
  const BivariatePolynomial line =
      BivariatePolynomial::r() * Polynomial(3) + BivariatePolynomial::s() * Polynomial(4);
  CHECK(fitted_gradient_norm(line, region, 0, 1) == BivariatePolynomial::constant(5));
  CHECK(fitted_gradient_norm(line, region, 2, Rational(1, 10)) == BivariatePolynomial::constant(5));
}

TEST_CASE("norms that are not defined are refused", "[gradient_norm]") {
  CHECK_THROWS_AS(fitted_gradient_norm(ellipse(), region, 9, 1), std::invalid_argument);
  CHECK_THROWS_AS(fitted_gradient_norm(ellipse(), region, 2, 0), std::invalid_argument);
  CHECK_THROWS_AS(fitted_gradient_norm(BivariatePolynomial::constant(2), region, 2, 1),
                  std::invalid_argument);
  CHECK_THROWS_AS(fitted_gradient_norm(ellipse(), {{Rational(1), Rational(1)}, region.y}, 2, 1),
                  std::invalid_argument);
}

}  // namespace exsect::gradient_norm_test
