#include <exsect/algebra/ball.h>
#include <exsect/algebra/double_double_ball.h>

#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::ball_test {

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
      switch (generator() % 5) {
        case 4: {
          const Ball before = ball;
          exact += exact * q;
          add_product(ball, before, b);
          break;
        }
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

/// Underflow must not claim a sign, and overflow no bound.
template <class Ball>
void check_limits() {
  const Ball tiny_squared = Ball(0x1p-600) * Ball(0x1p-600);
  CHECK(tiny_squared.certain_sign() == 0);
  CHECK(tiny_squared.upper_magnitude() > 0);
  for (const Ball& infinite : {Ball(1e300) * Ball(1e300), Ball(1.5e308) + Ball(1.5e308)}) {
    CHECK(infinite.certain_sign() == 0);
    CHECK(infinite.lower_magnitude() == 0);
    CHECK_FALSE(infinite.upper_magnitude() < 1e308);
  }
}

}  // namespace

TEST_CASE("balls at awkward values", "[ball]") {
  check_extremes<DoubleBall>();
  check_extremes<DoubleDoubleBall>();
  check_extremes<ArbBall<256>>();
  check_limits<DoubleBall>();
  check_limits<DoubleDoubleBall>();
}

TEST_CASE("balls of two doubles keep 104 bits", "[ball]") {
  const auto relative_radius = [](const DoubleDoubleBall& b) {
    return b.radius() / std::fabs(b.approximation());
  };
  const DoubleDoubleBall third = DoubleDoubleBall::enclosing(Rational(1, 3));
  CHECK(relative_radius(third) < 0x1p-104);
  CHECK(relative_radius(third * third) < 0x1p-102);
  CHECK(relative_radius(third + DoubleDoubleBall(1)) < 0x1p-103);
  CHECK((third * DoubleDoubleBall(3) - DoubleDoubleBall(1)).upper_magnitude() < 0x1p-101);
  const DoubleDoubleBall exact = DoubleDoubleBall::sum(1, 0x1p-90);  // sums and products without a rounding
  CHECK((exact - DoubleDoubleBall(1)).approximation() == 0x1p-90);
  CHECK(DoubleDoubleBall::sum(0x1p-90, 1).remainder() == 0x1p-90);
  CHECK((exact * exact - DoubleDoubleBall::sum(1, 0x1p-89)).upper_magnitude() < 0x1p-140);
}

TEST_CASE("the hull of two balls contains both, and nothing is known of it where nothing is of one",
          "[ball]") {
  const double huge = std::numeric_limits<double>::max(), nan = std::nan("");
  const std::vector<DoubleBall> balls = {DoubleBall(0),          {1, 1},
                                         {-3, 0x1p-60},          {0x1p-1074, 0},
                                         {1 + 0x1p-52, 0x1p-53}, DoubleBall::enclosing(Rational(1, 3)),
                                         {-0x1p900, 0x1p899}};
  for (const DoubleBall& a : balls)
    for (const DoubleBall& b : balls) {
      const RationalInterval both = hull(a, b).interval();
      for (const DoubleBall& ball : {a, b}) {
        CHECK(both.lower <= ball.interval().lower);
        CHECK(both.upper >= ball.interval().upper);
      }
      const Rational width =
          std::max(a.interval().upper, b.interval().upper) - std::min(a.interval().lower, b.interval().lower);
      const Rational size = Rational(from_double(a.upper_magnitude()) + from_double(b.upper_magnitude()));
      CHECK(both.width() <= width + size * power_of_two(-45) + power_of_two(-900));
    }
  for (const DoubleBall& unknown :
       {DoubleBall(nan), DoubleBall(0, nan), DoubleBall(0, HUGE_VAL), DoubleBall(huge) + DoubleBall(huge)})
    for (const DoubleBall& both : {hull(unknown, DoubleBall(1)), hull(DoubleBall(1), unknown)}) {
      CHECK(both.certain_sign() == 0);
      CHECK_FALSE(both.upper_magnitude() < huge);
    }
  CHECK_FALSE(DoubleBall::between(nan, 1).upper_magnitude() < huge);
  CHECK_FALSE(DoubleBall::between(1, nan).upper_magnitude() < huge);
}

TEST_CASE("balls enclose exact results", "[ball]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    check_chain<DoubleBall>(seed);
    check_chain<DoubleDoubleBall>(seed);
    check_chain<ArbBall<256>>(seed);
  }
}

}  // namespace exsect::ball_test
