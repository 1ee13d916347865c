#include <exsect/algebra/nearest_double.h>

#include <random>

#include "support/catch.h"

namespace exsect::nearest_double_test {
namespace {

void check(const Rational& q) {
  INFO(q);
  const NearestDouble d = nearest_double(q);
  CHECK(d.value == to_double(q));
  if (d.exact) CHECK(from_double(d.value) == q);
}

}  // namespace

TEST_CASE("nearest double: awkward numbers") {
  const Integer big = Integer(1) << 53;
  for (const Rational& q :
       {Rational(0), Rational(1), Rational(-1, 3), Rational(big), Rational(big + 1), Rational(big - 1) / big,
        Rational(1) / (big + 1), Rational(1) / (big - 1), power_of_two(-999), power_of_two(-1074),
        power_of_two(-1075), power_of_two(1023), Rational(big - 1) * power_of_two(-1060), Rational(3, 10)}) {
    check(q);
    check(-q);
  }
  CHECK(nearest_double(Rational(-5, 16)).exact);
  CHECK_FALSE(nearest_double(Rational(1, 3)).exact);
}

TEST_CASE("nearest double: random numbers") {
  std::mt19937_64 generator(1);
  for (int i = 0; i < 2000; ++i) {
    const unsigned shift = generator() % 64;
    const Integer n = static_cast<std::int64_t>(generator()) >> shift;
    const Integer d = Integer((generator() >> (generator() % 64)) | 1U) << (generator() % 90);
    check(Rational(n) / d);
  }
}

}  // namespace exsect::nearest_double_test
