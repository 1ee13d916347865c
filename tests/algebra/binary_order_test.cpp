#include <exsect/algebra/binary_order.h>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::binary_order_test {

TEST_CASE("binary order: powers of two, signs, numbers of any size") {
  CHECK(binary_order(1) == 0);
  CHECK(binary_order(-1) == 0);
  CHECK(binary_order(Rational(2, 3)) == 0);
  CHECK(binary_order(Rational(-3, 2)) == 0);
  for (const long n : {-2000L, -1L, 1L, 63L, 64L, 2000L}) CHECK(binary_order(power_of_two(n)) == n);
  const std::uint64_t seed = 63;
  INFO("seed " << seed);
  test::Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const Integer a = random.big_integer(random.integer(1, 200)),
                  b = random.big_integer(random.integer(1, 200));
    if (a == 0 || b == 0) continue;
    const Rational q(a, b);
    const long n = binary_order(q);
    CHECK(power_of_two(n - 1) < abs(q));
    CHECK(abs(q) < power_of_two(n + 1));
  }
}

}  // namespace exsect::binary_order_test
