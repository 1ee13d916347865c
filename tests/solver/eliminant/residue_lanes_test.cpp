#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "eliminant/vector_eliminant.h"
#include "support/catch.h"

// The header is for files compiled for AVX2; here only the functions between these lines are.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#include "eliminant/residue_lanes.h"

namespace exsect::residue_lanes_test {

namespace {

struct Results {
  double few[4];
  double many[4];
  double product[4];
  double product_and_sum[4];
};

lanes::Lane load(const std::array<double, 4>& a) { return _mm256_loadu_pd(a.data()); }

/// Sums of the products a[i] b[i]: the first three, and all; then a[0] b[0], and a[0] b[0] + a[1].
Results calculate(const std::array<double, 4>& p, const std::vector<std::array<double, 4>>& a,
                  const std::vector<std::array<double, 4>>& b) {
  const lanes::Primes f{load(p), _mm256_div_pd(_mm256_set1_pd(1), load(p))};
  lanes::LaneSum sum;
  Results result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum.add(load(a[i]), load(b[i]));
    if (i == 2) _mm256_storeu_pd(result.few, sum.reduced_few(f));
  }
  _mm256_storeu_pd(result.many, sum.reduced(f));
  _mm256_storeu_pd(result.product, lanes::multiply(f, load(a[0]), load(b[0])));
  _mm256_storeu_pd(result.product_and_sum, lanes::multiply_add(f, load(a[0]), load(b[0]), load(a[1])));
  return result;
}

}  // namespace

#pragma GCC pop_options

namespace {

__extension__ typedef __int128 Wide;

/// An integer of modulus at most 0.61 p: the ends, near zero, or random.
double awkward(double p, int kind, std::mt19937_64& random) {
  const double end = std::floor(0.61 * p);
  switch (kind) {
    case 0:
      return end;
    case 1:
      return (random() & 1) == 0 ? end : -end;
    case 2:
      return static_cast<double>(random() % 3) - 1;
    default:
      return std::floor((static_cast<double>(random() >> 11) * 0x1p-52 - 1) * end);
  }
}

bool congruent(double a, Wide b, double p) {
  return a == std::trunc(a) && (static_cast<Wide>(a) - b) % static_cast<Wide>(p) == 0;
}

}  // namespace

TEST_CASE("sums of products in lanes are exact up to the largest residues", "[vector_eliminant]") {
  if (!has_vector_eliminant()) return;
  std::mt19937_64 random(15);
  for (int trial = 0; trial < 400; ++trial) {
    INFO("trial " << trial);
    LanePrimes primes;
    std::array<double, 4> p;
    for (auto& prime : p) prime = static_cast<double>(primes.next());
    const auto lane_values = [&](int kind) {
      std::vector<std::array<double, 4>> values(28);
      for (auto& row : values)
        for (std::size_t lane = 0; lane < 4; ++lane) row[lane] = awkward(p[lane], kind, random);
      return values;
    };
    const auto a = lane_values(trial % 4);
    const auto b = lane_values(trial / 4 % 4);
    const Results results = calculate(p, a, b);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      Wide few = 0;
      Wide many = 0;
      for (std::size_t i = 0; i < a.size(); ++i) {
        many += static_cast<Wide>(a[i][lane]) * static_cast<Wide>(b[i][lane]);
        if (i == 2) few = many;
      }
      const Wide product = static_cast<Wide>(a[0][lane]) * static_cast<Wide>(b[0][lane]);
      CHECK(congruent(results.few[lane], few, p[lane]));
      CHECK(congruent(results.many[lane], many, p[lane]));
      CHECK(congruent(results.product[lane], product, p[lane]));
      CHECK(congruent(results.product_and_sum[lane], product + static_cast<Wide>(a[1][lane]), p[lane]));
      CHECK(std::abs(results.few[lane]) <= 0.61 * p[lane]);
      CHECK(std::abs(results.many[lane]) <= 0.501 * p[lane]);
      CHECK(std::abs(results.product[lane]) <= 0.535 * p[lane]);
      CHECK(std::abs(results.product_and_sum[lane]) <= 0.535 * p[lane]);
    }
  }
}

}  // namespace exsect::residue_lanes_test

#endif
