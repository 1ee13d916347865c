#include <exsect/algebra/ball.h>

#include <random>

#include "support/catch.h"

using exsect::ArbBall;
using exsect::DoubleBall;
using exsect::Rational;
using exsect::RationalInterval;

namespace {

bool encloses(const RationalInterval& interval, const Rational& q) {
  return interval.lower <= q && q <= interval.upper;
}

Rational random_rational(std::mt19937_64& generator) {
  const auto numerator = static_cast<long>(generator() % 2000001) - 1000000;
  const auto denominator = static_cast<long>(generator() % 1000) + 1;
  return Rational(numerator, denominator);
}

/// A chain of operations carried along exactly and in balls: the exact value must stay enclosed.
template <class Ball>
void check_chain(unsigned seed) {
  INFO("seed " << seed);
  std::mt19937_64 generator(seed);
  for (int round = 0; round < 50; ++round) {
    Rational exact = random_rational(generator);
    Ball ball = Ball::enclosing(exact);
    for (int step = 0; step < 25; ++step) {
      const Rational q = random_rational(generator);
      const Ball b = Ball::enclosing(q);
      switch (generator() % 4) {
        case 0:
          exact += q;
          ball += b;
          break;
        case 1:
          exact -= q;
          ball -= b;
          break;
        case 2:
          exact = -exact * q;
          ball = -ball * b;
          break;
        default:  // cancellation: subtract a neighbour of the value itself
          exact -= exsect::from_double(ball.approximation());
          ball -= Ball(ball.approximation());
      }
      REQUIRE(encloses(ball.interval(), exact));
      REQUIRE(exsect::from_double(ball.upper_magnitude()) >= abs(exact));
      REQUIRE(exsect::from_double(ball.lower_magnitude()) <= abs(exact));
      if (ball.certain_sign() != 0) {
        REQUIRE(ball.certain_sign() == exsect::sign(exact));
      }
    }
  }
}

template <class Ball>
void check_extremes() {
  CHECK(Ball(0.0).certain_sign() == 0);
  CHECK(Ball(1.0, 1.0).certain_sign() == 0);  // the closed ball reaches 0
  CHECK(Ball(1.0, 0.5).is_positive());
  CHECK(Ball(-1.0, 0.5).is_negative());
  CHECK(Ball(3.0, 1.0).lower_magnitude() <= 2.0);
  CHECK(Ball(3.0, 1.0).upper_magnitude() >= 4.0);
  CHECK(Ball(3.0, 1.0).midpoint().radius() == 0);
  CHECK(Ball(3.0).widened(2.0).radius() >= 2.0);
  CHECK(encloses(Ball::enclosing(Rational(1, 3)).interval(), Rational(1, 3)));
  const RationalInterval third = {Rational(1, 3), Rational(2, 3)};
  CHECK(encloses(Ball::enclosing(third).interval(), third.lower));
  CHECK(encloses(Ball::enclosing(third).interval(), third.upper));
}

}  // namespace

TEST_CASE("balls at awkward values", "[ball]") {
  check_extremes<DoubleBall>();
  check_extremes<ArbBall<256>>();
  const DoubleBall tiny_squared =
      DoubleBall(0x1p-600) * DoubleBall(0x1p-600);  // underflows: must not claim a sign
  CHECK(tiny_squared.certain_sign() == 0);
  CHECK(tiny_squared.upper_magnitude() > 0);
  const DoubleBall infinite = DoubleBall(1e300) * DoubleBall(1e300);
  CHECK(infinite.certain_sign() == 0);
  CHECK_FALSE(infinite.upper_magnitude() < 1e308);
}

TEST_CASE("balls enclose exact results", "[ball]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    check_chain<DoubleBall>(seed);
    check_chain<ArbBall<256>>(seed);
  }
}
