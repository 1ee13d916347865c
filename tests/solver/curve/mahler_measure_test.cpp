#include "curve/mahler_measure.h"

#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::mahler_measure_test {

TEST_CASE("bounds of logarithms enclose them tightly", "[mahler_measure]") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const double x = std::ldexp(std::uniform_real_distribution<double>(0.5, 1)(random), i - 500);
    const double error = log2_upper(x) - std::log2(x);
    CHECK(error >= 0);
    CHECK(error < 0.0862);
    const Integer a = Integer(random() | 1) << static_cast<unsigned>(i);
    const double log2_a = std::log2(static_cast<double>(a >> static_cast<unsigned>(i))) + i;
    CHECK(log2_lower(-a) <= log2_a);
    CHECK(log2_lower(a) > log2_a - 0.0862);
    CHECK(log2_upper(-a) >= log2_a);
    CHECK(log2_upper(a) < log2_a + 0.0862);
  }
  CHECK(log2_lower(1) <= 0);
  CHECK(log2_upper(Integer(1)) >= 0);
}

TEST_CASE("the measure of a polynomial lies between its bounds", "[mahler_measure]") {
  CHECK_FALSE(measure_lower({}).has_value());
  CHECK_FALSE(measure_lower({0, 0, 0}).has_value());
  struct Known {
    std::vector<Integer> f;
    double measure;  // sum of log2 max(1,|root|) plus log2 of the leading coefficient
  };
  const std::vector<Known> cases = {
      {{1}, 0},
      {{-8, 0}, 3},
      {{0, 0, 5}, std::log2(5)},
      {{-2, 1}, 1},
      {{1, -2}, 1},
      {{1, 0, 1}, 0},
      {{6, -5, 1}, std::log2(6)},
      {{2, -5, 2}, 2},                                   // roots 2 and 1/2
      {{-1, -1, 1}, std::log2((1 + std::sqrt(5)) / 2)},  // golden ratio
      {{1, 1, 1, 1, 1}, 0},                              // roots of unity
      {{1, 4, 6, 4, 1}, 0},                              // (t+1)^4
  };
  for (const auto& [f, measure] : cases) {
    const double lower = *measure_lower(f);
    INFO("measure " << measure << ", lower bound " << lower);
    CHECK(lower <= measure + 1e-12);
    CHECK(lower > measure - 0.5);
    CHECK(log2_norm_upper(f) >= measure);
  }
}

}  // namespace exsect::mahler_measure_test
