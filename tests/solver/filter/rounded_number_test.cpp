// Error bounds of plain doubles against exact arithmetic.
#include "filter/rounded_number.h"

#include <exsect/algebra/rational.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::rounded_number_test {
namespace {

/// Some sums, differences and products that cancel in part.
template <class T>
T formula(const T& a, const T& b, const T& c) {
  const T d = a * b - c, e = (a + b) * (a - b) + T(3) * c * c;
  return -(d * e) + (d - T(7)) * a - e * b * c;
}

}  // namespace

TEST_CASE("rounded number: bounds magnitude and error of doubles, for inputs that are rounded themselves") {
  std::mt19937_64 generator(11);
  const auto number = [&](double most) {
    return std::uniform_real_distribution<double>(-most, most)(generator);
  };
  for (const double size : {1e-150, 1e-3, 1.0, 40.0, 1e30}) {
    const double off = size * 0x1p-49;
    const RoundedNumber input(size, off);
    const RoundedNumber bound = formula(input, input, input);
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
      std::array<double, 3> x;
      std::array<Rational, 3> exact;
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] = i == 0 ? size : number(size);
        exact[k] = from_double(x[k]) + from_double(i % 2 == 0 ? off : number(off));
      }
      const double computed = formula(x[0], x[1], x[2]);
      const Rational error = abs(Rational(from_double(computed) - formula(exact[0], exact[1], exact[2])));
      REQUIRE(error <= from_double(bound.error()));
      REQUIRE(std::fabs(computed) <= bound.most());
      worst = std::max(worst, to_double(error));
    }
    CHECK(bound.error() < 100 * worst + 1e-300);
  }
}

TEST_CASE("rounded number: exact doubles, the middle of balls, and overflow") {
  CHECK(RoundedNumber(-3).most() == 3);
  CHECK(RoundedNumber(-3).error() == 0);
  const RoundedNumber ball = RoundedNumber::of(DoubleBall(-2, 0.25));
  CHECK(ball.most() == 2);
  CHECK(ball.error() == 0.25);
  // 0.1 + 0.2 is not the double next to the sum of both.
  const RoundedNumber sum = RoundedNumber(0.1) + RoundedNumber(0.2);
  CHECK(from_double(sum.error()) >=
        abs(Rational(from_double(0.1 + 0.2) - from_double(0.1) - from_double(0.2))));
  CHECK(sum.error() < 0x1p-53);
  const RoundedNumber huge(1e200);
  CHECK_FALSE((huge * huge).error() < INFINITY);
}

}  // namespace exsect::rounded_number_test
