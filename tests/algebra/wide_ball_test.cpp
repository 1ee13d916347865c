#include <exsect/algebra/wide_ball.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/catch.h"

namespace exsect::wide_ball_test {

namespace {

struct Number {
  Rational exact;
  WideBall ball;
};

bool holds(const WideBall& ball, const Rational& value) {
  const RationalInterval interval = ball.interval();
  return interval.lower <= value && value <= interval.upper;
}

/// All limbs, single bits, long runs of ones; exponents that are equal, near, or farther apart than all bits.
Number number(std::mt19937_64& random) {
  Integer n = 0;
  for (int i = 0; i < 4; ++i) n = (n << 64) + Integer(random());
  switch (random() % 5) {
    case 0:
      n = Integer(1) << static_cast<unsigned>(random() % 256);
      break;
    case 1:
      n = (Integer(1) << static_cast<unsigned>(random() % 257)) - 1;
      break;
    case 2:
      n >>= static_cast<unsigned>(random() % 250);
      break;
    default:
      break;
  }
  if (random() % 2 == 0) n = -n;
  const long far =
      random() % 4 == 0 ? static_cast<long>(random() % 700) - 350 : static_cast<long>(random() % 3);
  const Rational exact = Rational(n) * power_of_two(-256 + far);
  WideBall ball = WideBall::enclosing(n, -256 + far);
  CHECK(ball.radius() == 0);
  CHECK(holds(ball, exact));
  if (random() % 3 != 0) return {exact, ball};
  const double radius = std::ldexp(1, static_cast<int>(far) - 200);
  return {exact + from_double(radius) * (static_cast<long>(random() % 3) - 1), ball.widened(radius)};
}

}  // namespace

TEST_CASE("wide ball: exact numbers and signs", "[wide_ball]") {
  CHECK(WideBall().certain_sign() == 0);
  CHECK(holds(WideBall(), 0));
  for (const double x : {1.0, -0.75, 1e300, 1e-270, -3.0, 0x1.fffffffffffffp+0}) {
    const WideBall ball(x);
    CHECK(ball.radius() == 0);
    CHECK(ball.interval().lower == from_double(x));
    CHECK(ball.interval().upper == from_double(x));
    CHECK(std::fabs(ball.approximation() - x) <= std::fabs(x) * 0x1p-49);
    CHECK((-ball).certain_sign() == (x < 0 ? 1 : -1));
  }
  CHECK(WideBall(5e-324).interval().lower == from_double(5e-324));
  CHECK(WideBall(5e-324).certain_sign() == 0);
  CHECK(WideBall(1).widened(0.5).certain_sign() == 1);
  CHECK(WideBall(1).widened(1).certain_sign() == 0);
  CHECK((WideBall(1) - WideBall(1)).certain_sign() == 0);
  CHECK(scaled(WideBall(3), -7).interval().lower == Rational(3, 128));
  const WideBall third = WideBall::enclosing(Integer(1) << 900, -900 - 2);
  CHECK(third.interval().lower <= Rational(1, 4));
}

TEST_CASE("wide ball: what is not known is never decided", "[wide_ball]") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(inverse(WideBall()).radius() == infinity);
  CHECK(inverse(WideBall(1).widened(2)).radius() == infinity);
  CHECK((inverse(WideBall()) * WideBall(2)).certain_sign() == 0);
  CHECK((inverse(WideBall()) + WideBall(2)).certain_sign() == 0);
  WideBall huge(1e300), tiny(1e-300);
  for (int i = 0; i < 5; ++i) {
    huge = huge * huge;
    tiny = tiny * tiny;
  }
  CHECK(huge.certain_sign() == 0);
  CHECK(tiny.certain_sign() == 0);
  CHECK((huge * tiny).certain_sign() == 0);
}

TEST_CASE("wide ball: operations enclose the exact results", "[wide_ball]") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 3000; ++i) {
    const Number a = number(random), b = number(random), c = number(random);
    CHECK(holds(a.ball + b.ball, a.exact + b.exact));
    CHECK(holds(a.ball - b.ball, a.exact - b.exact));
    CHECK(holds(a.ball * b.ball, a.exact * b.exact));
    CHECK(holds(scaled(a.ball, -5), a.exact / 32));
    WideBall::Sum sum(a.ball, b.ball);
    sum.add(c.ball);
    sum.add(-b.ball, c.ball);
    CHECK(holds(sum.rounded(), a.exact * b.exact + c.exact - b.exact * c.exact));
    if (a.ball.certain_sign() != 0) {
      CHECK(a.ball.certain_sign() == sign(a.exact));
      const WideBall one_over = inverse(a.ball);
      CHECK(holds(one_over, 1 / a.exact));
      const double relative = one_over.radius() / one_over.magnitude();
      CHECK(relative <= 3 * a.ball.radius() / a.ball.lower_magnitude() + 0x1p-250);
    }
  }
}

TEST_CASE("wide ball: sums cancel exactly and lose little", "[wide_ball]") {
  std::mt19937_64 random(7);
  const Number a = number(random), b = number(random);
  WideBall::Sum sum;
  for (int i = 0; i < 1000; ++i) {
    sum.add(WideBall(i % 2 == 0 ? 1 : -1), WideBall(0x1.8p+0));
  }
  CHECK(holds(sum.rounded(), 0));
  CHECK(sum.rounded().radius() <= 0x1p-240);
  WideBall::Sum many;
  Rational exact = 0;
  for (int i = 0; i < 2000; ++i) {  // beyond the limb above the midpoints
    many.add(a.ball.midpoint(), a.ball.midpoint());
    exact += a.ball.midpoint().interval().lower * a.ball.midpoint().interval().lower;
  }
  CHECK(holds(many.rounded(), exact));
  CHECK(many.rounded().radius() <= many.rounded().magnitude() * 0x1p-248);
  CHECK((b.ball * b.ball).radius() <=
        (b.ball * b.ball).magnitude() * (0x1p-250 + 3 * b.ball.radius() / b.ball.magnitude()));
}

}  // namespace exsect::wide_ball_test
