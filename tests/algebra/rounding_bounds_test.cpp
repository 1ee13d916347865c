#include <exsect/algebra/rational.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <random>

#include "support/catch.h"

namespace exsect::rounding_bounds_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("rounding bounds: the greatest bound, none where one is none", "[rounding bounds]") {
  CHECK(larger_bound(1, 2) == 2);
  CHECK(larger_bound(2, 1) == 2);
  CHECK(larger_bound(2, 2) == 2);
  CHECK(larger_bound(0, 3, 1, 2) == 3);
  CHECK(larger_bound(infinity, 1) == infinity);
  for (std::size_t place = 0; place < 4; ++place) {
    std::array<double, 4> bounds = {1, 2, 3, infinity};
    bounds[place] = nan;
    CHECK(std::isnan(larger_bound(bounds[0], bounds[1], bounds[2], bounds[3])));
    CHECK(std::isnan(larger_bound(bounds[3], bounds[2], bounds[1], bounds[0])));
  }
  CHECK(std::isnan(larger_bound(-nan, 1)));
  CHECK(std::isnan(larger_bound(1, -nan)));
}

TEST_CASE("rounding bounds: lengths whose squares underflow or overflow", "[rounding bounds]") {
  CHECK(length_bound(0, 0, 0) == 0);
  CHECK(length_bound(0, 0x1p-540, 0) >= 0x1p-540);
  CHECK(length_bound(0x1p-600, 0, 0x1p-600) >= 1.4 * 0x1p-600);
  CHECK(length_bound(3e200, -4e200, 0) >= 5e200);
  CHECK(length_bound(3e200, -4e200, 0) <= 5.01e200);
  CHECK(std::isnan(length_bound(0, nan, 0)));
  CHECK(std::isnan(length_bound(nan, 0, 0)));
  CHECK(std::isnan(length_bound(0, 0, nan)));
}

TEST_CASE("rounding bounds: lengths of random vectors against exact squares", "[rounding bounds]") {
  const unsigned seed = 20;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> digits(-1, 1);
  std::uniform_int_distribution<int> exponent(-500, 500);
  for (int i = 0; i < 2000; ++i) {
    std::array<double, 3> v{};
    Rational square = 0;
    for (double& c : v) {
      c = std::ldexp(digits(random), exponent(random));
      square += from_double(c) * from_double(c);
    }
    const Rational bound = from_double(length_bound(v[0], v[1], v[2]));
    CAPTURE(v[0], v[1], v[2]);
    CHECK(bound * bound >= square);
    CHECK(bound * bound <= square * from_double(1 + 0x1p-38));
  }
}

}  // namespace exsect::rounding_bounds_test
