// Strips that a plane curve does not meet: in doubles and in long numbers, and against exact values.
#include "curve/plane_strip.h"

#include <random>

#include "solver/curve/random_curve.h"
#include "support/catch.h"

namespace exsect::plane_strip_test {

using random_curve::random_curve;

namespace {

template <class Ball>
std::optional<double> clear(const BivariatePolynomial& f, double u0, double v0, double u1, double v1,
                            double w) {
  return PlaneStrip<Ball>(f).clear({Ball(u0), Ball(v0)}, {Ball(u1), Ball(v1)}, w, 0);
}

}  // namespace

TEST_CASE("plane strips: doubles prove what long numbers prove, and no more", "[curve]") {
  const unsigned seed = 11;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0, 1);
  int proved = 0, only_long = 0;
  for (int i = 0; i < 400; ++i) {
    const int m = 1 + i % 12, n = 1 + i % 8;
    const BivariatePolynomial f = random_curve(generator, m, n);
    const double u0 = place(generator), v0 = place(generator);
    const double u1 = u0 + 1e-3 * (place(generator) - 0.5), v1 = v0 + 1e-3 * (place(generator) - 0.5);
    const double w = 1e-4 * place(generator);
    const auto in_doubles = clear<DoubleBall>(f, u0, v0, u1, v1, w);
    const auto in_long_numbers = clear<ArbBall<256>>(f, u0, v0, u1, v1, w);
    proved += in_doubles ? 1 : 0;
    only_long += in_long_numbers && !in_doubles ? 1 : 0;
    if (in_doubles) CHECK(in_long_numbers);
    if (!in_doubles) continue;
    // The exact polynomial has one sign along both edges.
    for (const double edge : {-w, w}) {
      int positive = 0;
      for (int k = 0; k <= 8; ++k) {
        const Rational t(k, 8);
        const Rational u = from_double(u0) + t * (from_double(u1) - from_double(u0));
        const Rational v = from_double(v0) + t * (from_double(v1) - from_double(v0)) + from_double(edge);
        positive += f(u, v) > 0 ? 1 : 0;
      }
      CHECK((positive == 0 || positive == 9));
    }
  }
  CHECK(proved > 300);
  CHECK(only_long <= 2);
}

TEST_CASE("plane strips: rounding does not hide a zero", "[curve]") {
  // (u - 1/3)^8 is below the errors of doubles about 1/3: they prove nothing, longer numbers do.
  BivariatePolynomial f = BivariatePolynomial::constant(power_of_two(-60));
  BivariatePolynomial power = BivariatePolynomial::constant(1);
  for (int k = 0; k < 8; ++k)
    power = power * (BivariatePolynomial::r() - BivariatePolynomial::constant(Rational(1, 3)));
  f += power;
  CHECK_FALSE(clear<DoubleBall>(f, 0.333, 0.5, 0.334, 0.5, 1e-5));
  CHECK(clear<ArbBall<256>>(f, 0.333, 0.5, 0.334, 0.5, 1e-5));
  // On short chords nothing but the errors is against it.
  for (int k = 1; k < 20; ++k) {
    const double u = 1.0 / 3 + k * 1e-5;
    CHECK_FALSE(clear<DoubleBall>(f, u, 0.5, u + 1e-9, 0.5, 1e-5));
    CHECK(clear<ArbBall<256>>(f, u, 0.5, u + 1e-9, 0.5, 1e-5));
  }
}

}  // namespace exsect::plane_strip_test
