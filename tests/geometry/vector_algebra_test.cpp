#include <exsect/algebra/polynomial.h>
#include <exsect/algebra/rational.h>
#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "support/catch.h"

namespace exsect::vector_algebra_test {
namespace {

/// The determinant by all permutations.
template <class Ring, std::size_t N>
Ring by_permutations(const std::array<std::array<Ring, N>, N>& rows) {
  std::array<std::size_t, N> order{};
  std::iota(order.begin(), order.end(), 0U);
  Ring sum(0);
  do {
    int sign = 1;
    Ring product(1);
    for (std::size_t i = 0; i < N; ++i) {
      product = product * rows[i][order[i]];
      for (std::size_t j = 0; j < i; ++j) sign = order[j] > order[i] ? -sign : sign;
    }
    sum = sum + Ring(sign) * product;
  } while (std::next_permutation(order.begin(), order.end()));
  return sum;
}

template <class Ring, class Random>
void check(const Random& random) {
  for (int round = 0; round < 50; ++round) {
    std::array<std::array<Ring, 3>, 3> m;
    for (auto& row : m)
      for (Ring& entry : row) entry = random();
    const auto& [a, b, c] = m;
    CHECK(determinant_over(a, b, c) == by_permutations(m));
    CHECK(dot_over(cross_over(a, b), c) == determinant_over(a, b, c));
    CHECK(dot_over(a, cross_over(a, b)) == Ring(0));
    // |a x b|² = |a|² |b|² - (a . b)²
    const auto n = cross_over(a, b);
    CHECK(dot_over(n, n) + dot_over(a, b) * dot_over(a, b) == dot_over(a, a) * dot_over(b, b));

    std::array<std::array<Ring, 4>, 4> four;
    for (auto& row : four)
      for (Ring& entry : row) entry = random();
    CHECK(determinant_over(four[0], four[1], four[2], four[3]) == by_permutations(four));
    CHECK(determinant_over(four[0], four[1], four[2], four[1]) == Ring(0));
  }
}

}  // namespace

TEST_CASE("vector algebra: over the rationals and polynomials, by permutations") {
  const unsigned seed = 11;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> any(-3, 3);
  const auto number = [&] { return Rational(any(generator), 2); };
  check<Rational>(number);
  check<Polynomial>([&] { return Polynomial({number(), number(), number()}); });
}

TEST_CASE("vector algebra: the axes of space") {
  using Vector = VectorOver<int>;
  const Vector x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
  CHECK(cross_over(x, y) == z);
  CHECK(cross_over(y, z) == x);
  CHECK(cross_over(z, x) == y);
  CHECK(determinant_over(x, y, z) == 1);
  CHECK(determinant_over(y, x, z) == -1);
}

}  // namespace exsect::vector_algebra_test
