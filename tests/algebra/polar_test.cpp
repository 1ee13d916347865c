#include <exsect/algebra/polar.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "support/catch.h"

namespace exsect::polar_test {
namespace {

RationalInterval at(const Rational& q) { return {q, q}; }
const Rational narrow = power_of_two(-118);

void check_turn(const Rational& x, const Rational& y, const Rational& expected) {
  const auto turn = turn_of(at(x), at(y));
  REQUIRE(turn);
  CHECK(turn->lower <= expected);
  CHECK(turn->upper >= expected);
  CHECK(turn->width() <= narrow);
}

}  // namespace

TEST_CASE("turns: eighths and twelfths of a whole turn") {
  const std::array<std::array<int, 2>, 8> compass = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  for (int i = 0; i < 8; ++i) {
    INFO("direction " << i);
    const auto& [x, y] = compass[static_cast<std::size_t>(i)];
    for (const Rational& scale : {Rational(1), power_of_two(-1200), power_of_two(1200), Rational(1, 3)})
      check_turn(scale * x, scale * y, Rational(i, 8));
  }
  // The box around (1/2, sqrt(3)/2), an irrational place.
  const RationalInterval root = root_of(at(3));
  const auto sixth = turn_of(at(1), root);
  REQUIRE(sixth);
  CHECK(sixth->lower <= Rational(1, 6));
  CHECK(sixth->upper >= Rational(1, 6));
  CHECK(sixth->width() < 4 * narrow);
}

TEST_CASE("turns: boxes around the half lines, about 0, and around the origin") {
  const Rational e(1, 1000);
  const auto start = turn_of(at(1), {-e, e});
  REQUIRE(start);
  CHECK((start->lower < 0 && start->upper > 0));
  CHECK(start->width() < e);
  const auto half = turn_of({-2, -1}, {-e, e});
  REQUIRE(half);
  CHECK((half->lower < Rational(1, 2) && half->upper > Rational(1, 2)));
  CHECK(half->width() < e);
  const auto above = turn_of(at(-1), {0, e});
  REQUIRE(above);
  CHECK(above->upper >= Rational(1, 2));
  CHECK(above->lower < Rational(1, 2));
  const auto upper = turn_of({-1, 1}, at(1));  // from 1/8 to 3/8
  REQUIRE(upper);
  CHECK((upper->lower <= Rational(1, 8) && upper->upper >= Rational(3, 8)));
  CHECK_FALSE(turn_of({-1, 1}, {-e, e}));
  CHECK_FALSE(turn_of(at(0), at(0)));
}

TEST_CASE("turns: random vectors as by the library of C") {
  const unsigned seed = 4711;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> number(-1000, 1000);
  for (int i = 0; i < 200; ++i) {
    const int x = number(random), y = number(random);
    if (x == 0 && y == 0) continue;
    const auto turn = turn_of(at(x), at(y));
    REQUIRE(turn);
    double expected = std::atan2(y, x) / (2 * std::numbers::pi);
    if (y < 0) expected += 1;
    CHECK(std::fabs(to_double(turn->midpoint()) - expected) < 1e-15);
    CHECK(turn->width() <= narrow);
  }
}

TEST_CASE("roots: enclosed by their squares, exact at squares of short numbers") {
  for (const Rational& q :
       {Rational(2), Rational(1, 7), power_of_two(-301), power_of_two(901), Rational(1000003)}) {
    const RationalInterval root = root_of(at(q));
    CHECK(root.lower * root.lower <= q);
    CHECK(root.upper * root.upper >= q);
    CHECK(root.width() <= narrow * root.upper);
  }
  CHECK((root_of(at(0)).lower == 0 && root_of(at(0)).upper == 0));
  const RationalInterval exact = root_of(at(Rational(9, 4)));
  CHECK((exact.lower == Rational(3, 2) && exact.upper == Rational(3, 2)));
  CHECK(root_of({-1, 4}).lower == 0);
  CHECK(root_of({-1, 4}).upper >= 2);
  CHECK_THROWS_AS(root_of(at(-1)), std::domain_error);
}

}  // namespace exsect::polar_test
