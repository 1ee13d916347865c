// Zeros of three polynomials against known points, and systems that have none or multiple ones.
#include "lift/space_zero.h"

#include "support/catch.h"

namespace exsect::space_zero_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                      z = SpacePolynomial::variable(2);
SpacePolynomial number(const Rational& c) { return SpacePolynomial::constant(c); }

/// The positive root of q is in the interval of one coordinate.
bool holds_root(const SpaceZero& zero, std::size_t k, const Rational& q) {
  const Rational r = from_double(zero.radius), lower = zero.centre[k] - r, upper = zero.centre[k] + r;
  return lower > 0 && lower * lower <= q && q <= upper * upper;
}

}  // namespace

TEST_CASE("space zero: planes, and a point of which one coordinate is irrational") {
  const auto corner = space_zero({x - number(1), y - number(Rational(1, 3)), x + z}, {0, 0, 0}, 0x1p-80);
  REQUIRE(corner);
  CHECK(abs(corner->centre[1] - Rational(1, 3)) <= from_double(corner->radius));
  for (const double radius : {0x1p-20, 0x1p-60, 0x1p-120, 0x1p-200}) {
    const SpaceSystem system = {x * x + y * y + z * z - number(2), y, z};
    const auto zero = space_zero(system, {1, Rational(1, 10), 0}, radius);
    REQUIRE(zero);
    CHECK(zero->radius == radius);
    CHECK(holds_root(*zero, 0, 2));
    CHECK(sign_on(x, *zero) == 1);
    CHECK(sign_on(y - number(1), *zero) == -1);
    CHECK(sign_on(x * x - number(2), *zero) == 0);
    CHECK(orientation_on(system, *zero) == 1);
    CHECK(orientation_on({system[1], system[0], system[2]}, *zero) == -1);
  }
}

TEST_CASE("space zero: no zero, a double one, dependent gradients") {
  CHECK(!space_zero({x * x + number(1), y, z}, {1, 0, 0}, 0x1p-40));
  CHECK(!space_zero({x * x, y, z}, {Rational(1, 2), 0, 0}, 0x1p-40));
  CHECK(!space_zero({x, x, z}, {1, 1, 1}, 0x1p-40));
  CHECK(!space_zero({x * x + y * y - number(1), y - number(1), z}, {Rational(1, 7), 1, 0}, 0x1p-40));
  // Two zeros at the distance 2^-30 are not one.
  const SpaceSystem near = {x * x - number(power_of_two(-62)), y, z};
  CHECK(!space_zero(near, {power_of_two(-31), 0, 0}, 0x1p-28));
  CHECK(space_zero(near, {power_of_two(-31), 0, 0}, 0x1p-34));
}

TEST_CASE("space zero: far away and small") {
  const Rational far = power_of_two(70);
  const SpacePolynomial moved = x - number(far);
  const auto zero =
      space_zero({moved * moved + y * y - number(3), y - number(1), z + y}, {far + 1, 1, 0}, 0x1p-90);
  REQUIRE(zero);
  CHECK(holds_root({{zero->centre[0] - far, 0, 0}, zero->radius}, 0, 2));
}

}  // namespace exsect::space_zero_test
