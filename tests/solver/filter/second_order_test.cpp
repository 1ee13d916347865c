#include "filter/second_order.h"

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::second_order_test {
namespace {

using namespace filter;  // NOLINT(google-build-using-namespace): kinds

/// x W = X up to order two, term by term, and the same in doubles up to rounding.
template <class K>
void check(std::uint64_t seed) {
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  std::array<std::array<Rational, K::rows>, K::count> c;
  CoefficientsOf<K> rounded{};
  for (std::size_t i = 0; i < K::count; ++i)
    for (std::size_t row = 0; row < K::rows; ++row) {
      const int least = row == 3 && i == 0 ? 1 : -9;
      c[i][row] = Rational(random_pairs::integer(generator, least, 9), 8);
      rounded[i][row] = to_double(c[i][row]);
    }
  const ExactSecondOrder x = in_space<K>(c);
  const SecondOrder near = in_space<K>(rounded);
  const std::array<std::array<std::size_t, 2>, 6> powers = {{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
  const std::array<const Point*, 6> exact = {&x.value, &x.u, &x.v, &x.uu, &x.uv, &x.vv};
  const std::array<const Vec3*, 6> doubles = {&near.value, &near.u, &near.v, &near.uu, &near.uv, &near.vv};
  const auto weight = [&](std::size_t i, std::size_t j) {
    if constexpr (K::weighted) return c[K::side * i + j][3];
    return Rational(i + j == 0 ? 1 : 0);
  };
  for (std::size_t t = 0; t < 6; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [i, j] = powers[t];
      Rational sum = 0;
      for (std::size_t s = 0; s < 6; ++s)
        if (powers[s][0] <= i && powers[s][1] <= j)
          sum += (*exact[s])[k] * weight(i - powers[s][0], j - powers[s][1]);
      CHECK(sum == c[K::side * i + j][k]);
      const double value = to_double((*exact[t])[k]);
      CHECK((*doubles[t])[k] == Approx(value).epsilon(1e-9).margin(1e-9));
    }
}

}  // namespace

TEST_CASE("second order: a patch in space times its weight is its homogeneous form", "[filter]") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    check<Biquadratic>(seed);
    check<Bicubic>(seed);
    check<WeightedBiquadratic>(seed);
    check<WeightedBicubic>(seed);
  }
}

}  // namespace exsect::second_order_test
