// Polynomials about a point against exact values.
#include "lift/local_polynomial.h"

#include <random>

#include "support/catch.h"

namespace exsect::local_polynomial_test {
namespace {

bool holds(const DoubleBall& ball, const Rational& q) {
  const RationalInterval interval = ball.interval();
  return interval.lower <= q && q <= interval.upper;
}

/// The power of 2 by which the values are multiplied: that of the value or derivative that is not 0.
Rational scale_of(const DoubleBall& ball, const Rational& value) {
  return power_of_two(std::lround(std::log2(std::fabs(ball.approximation() / to_double(value)))));
}

}  // namespace

TEST_CASE("local polynomial: constants, and what is zero at the centre") {
  const SpacePolynomial x = SpacePolynomial::variable(0);
  const LocalPolynomial constant(SpacePolynomial::constant(-3), {1, 2, 3});
  CHECK(constant.value().certain_sign() == -1);
  CHECK(constant.gradient()[0].upper_magnitude() < 1e-200);
  const LocalPolynomial square(x * x, {0, 5, 7});
  CHECK(square.value().upper_magnitude() < 1e-200);
  CHECK(square.gradient()[0].upper_magnitude() < 1e-200);
  CHECK(square.value_on({DoubleBall(2), DoubleBall(), DoubleBall()}).is_positive());
}

TEST_CASE("local polynomial: nothing cancels far from the origin") {
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1);
  const Rational far = power_of_two(60);
  const SpacePolynomial shifted = x - SpacePolynomial::constant(far), f = shifted * shifted - y;
  const LocalPolynomial local(f, {far, power_of_two(-60), 0});
  CHECK(local.value().certain_sign() == -1);
  CHECK(local.value_on({DoubleBall(0x1p-29), DoubleBall(), DoubleBall()}).certain_sign() == 1);
}

TEST_CASE("local polynomial: random values, gradients and restrictions to lines") {
  const unsigned seed = 3;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> number(-9, 9), degree(1, 6);
  const auto point = [&] {
    return Point{Rational(number(random), 8), Rational(number(random), 4), number(random)};
  };
  for (int round = 0; round < 200; ++round) {
    SpacePolynomial::Terms terms;
    for (const Exponents& e : exponents_up_to(degree(random))) terms[e] = number(random);
    const SpacePolynomial f(terms);
    const Point c = point(), w = point();
    if (f.is_zero() || f(c) == 0) continue;
    const LocalPolynomial local(f, c);
    const Rational scale = scale_of(local.value(), f(c));
    CHECK(holds(local.value(), scale * f(c)));
    const SpaceBalls at = {to_double(w[0]), to_double(w[1]), to_double(w[2])};
    CHECK(holds(local.value_on(at), scale * f(c + w)));
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(holds(local.gradient()[k], scale * f.derivative(k)(c)));
      CHECK(holds(local.gradient_on(at)[k], scale * f.derivative(k)(c + w)));
    }
    DoubleBall sum;
    const std::vector<DoubleBall> along = local.along({to_double(w[0]), to_double(w[1]), to_double(w[2])});
    for (std::size_t i = along.size(); i-- > 0;) sum = sum * DoubleBall(0.5) + along[i];
    CHECK(holds(sum, scale * f(c + Rational(1, 2) * w)));
    // A box holds the values of its points.
    const SpaceBalls box = {DoubleBall(0, std::fabs(to_double(w[0]))),
                            DoubleBall(0, std::fabs(to_double(w[1]))),
                            DoubleBall(0, std::fabs(to_double(w[2])))};
    CHECK(holds(local.value_on(box), scale * f(c + w)));
    CHECK(holds(local.gradient_on(box)[1], scale * f.derivative(1)(c - w)));
    // Beside a chord, in its end and off it.
    const std::array<double, 3> m = {0.5, -1.25, 1};
    for (const double t : {-0.5, 0.25, 0.5}) {
      const Point p = c + from_double(t) * Point{from_double(m[0]), from_double(m[1]), 1};
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(holds(local.gradient_beside(m, 0.5, box)[k], scale * f.derivative(k)(p + w)));
    }
  }
}

TEST_CASE("local polynomial: a gradient that is nearly the same along a chord") {
  // x - y is 0 along the chord, so the derivative of (x - y)^2 is small beside it, not of the chord's length.
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1);
  const LocalPolynomial local((x - y) * (x - y) + SpacePolynomial::variable(2), {3, 3, 0});
  const SpaceBalls beside = {DoubleBall(), DoubleBall(0, 0x1p-40), DoubleBall()};
  CHECK(local.gradient_beside({1, 1, 0}, 0.5, beside)[1].upper_magnitude() < 0x1p-38);
  CHECK(local.gradient_on({DoubleBall(0, 0.5), DoubleBall(0, 0.5), DoubleBall()})[1].upper_magnitude() > 0.5);
}

}  // namespace exsect::local_polynomial_test
