#include "star/short_numbers.h"

#include <random>

#include "support/catch.h"

namespace exsect::short_numbers_test {

TEST_CASE("the largest power of two below a number") {
  CHECK(power_of_two_below(1) == 1);
  CHECK(power_of_two_below(Rational(1) - power_of_two(-200)) == 0.5);  // in doubles it is 1
  CHECK(power_of_two_below(Rational(1) + power_of_two(-200)) == 1);
  const unsigned seed = 11;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> digits(1, 1000000), exponent(-300, 300);
  for (int round = 0; round < 300; ++round) {
    const Rational at = Rational(digits(generator), digits(generator)) * power_of_two(exponent(generator));
    const Rational p = from_double(power_of_two_below(at));
    CHECK(p <= at);
    CHECK(2 * p > at);
  }
}

TEST_CASE("short numbers near others: as near as asked for, on a grid of powers of two") {
  const unsigned seed = 12;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> digits(1, 1000000), exponent(1, 250);
  for (int round = 0; round < 300; ++round) {
    const Rational at(digits(generator), 1000001), room = power_of_two(-exponent(generator)) / 3;
    const Rational near = short_near(at, room);
    CHECK(abs(near - at) <= room * power_of_two(-20));
    // A dyadic number: no finer than 2^-64 of what the room asks for, or than 2^-52.
    const Rational grid = std::min<Rational>(power_of_two(-52), room * power_of_two(-20 - 64));
    CHECK(denominator(near / grid * power_of_two(64)) == 1);
    CHECK(short_near(near, room) == near);
  }
}

}  // namespace exsect::short_numbers_test
