#include "support/small_features.h"

#include <array>

#include "support/catch.h"

namespace exsect::small_features_test {

namespace {

/// Features of every order of size, from 2^-20 to 2^-300.
constexpr std::array kBits = {20, 40, 60, 100, 150, 220, 300};

}  // namespace

TEST_CASE("features of any size are found, in closed form", "[features]") {
  const auto& families = small_features::families();
  for (std::size_t i = 0; i < families.size(); ++i) {
    for (std::size_t k = 0; k < kBits.size(); k += 3) {
      const int bits = kBits[(k + i) % kBits.size()];
      const std::uint64_t seed = 100 * i + k;
      INFO(families[i].name << ", 2^-" << bits << ", seed " << seed);
      CHECK(small_features::failure(families[i], bits, seed, false).empty());
    }
  }
}

TEST_CASE("features of moderate size have the same answers in exact mode", "[features]") {
  const auto& families = small_features::families();
  for (std::size_t i = 0; i < families.size(); ++i) {
    INFO(families[i].name);
    CHECK(small_features::failure(families[i], 12, i, true).empty());
  }
}

TEST_CASE("a wrong number of a feature is noticed", "[features]") {
  auto feature = small_features::example(small_features::families()[0], 60, 1);
  CHECK(counted_failure(feature.pair, feature.numbers, false).empty());
  ++feature.numbers.closed;
  CHECK_FALSE(counted_failure(feature.pair, feature.numbers, false).empty());
}

}  // namespace exsect::small_features_test
