#include "filter/exact_taylor.h"

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::exact_taylor_test {
namespace {

using namespace filter;  // NOLINT(google-build-using-namespace): kinds

/// sum c[side i + j] h^i k^j
template <class K>
std::array<Rational, K::rows> summed(const ExactTaylor<K>& c, const Rational& h, const Rational& k) {
  std::array<Rational, K::rows> sum{};
  Rational in_h = 1;
  for (std::size_t i = 0; i < K::side; ++i, in_h *= h) {
    Rational power = in_h;
    for (std::size_t j = 0; j < K::side; ++j, power *= k)
      for (std::size_t row = 0; row < K::rows; ++row) sum[row] += c[K::side * i + j][row] * power;
  }
  return sum;
}

RationalPatch random_patch(random_pairs::Generator& generator, int degree, bool weighted) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= degree; ++i) {
    auto& row = net.emplace_back();
    for (int j = 0; j <= degree; ++j) {
      HomogeneousPoint p;
      for (Rational& c : p) c = Rational(random_pairs::integer(generator, -9, 9), 7);
      p[3] = weighted ? Rational(random_pairs::integer(generator, 1, 9), 5) : Rational(1);
      row.push_back(p);
    }
  }
  return RationalPatch::from_homogeneous(net);
}

/// The expansion about one place, summed at another one, is the patch there, by (4.1)-like de Casteljau
/// values.
template <class K>
void check(std::uint64_t seed) {
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int round = 0; round < 10; ++round) {
    const RationalPatch patch = random_patch(generator, static_cast<int>(K::degree), K::weighted);
    const ElevatedPatch<K> exact = elevated<K>(patch);
    const Rational u(random_pairs::integer(generator, -8, 16), 8),
        v(random_pairs::integer(generator, -8, 16), 8);
    const ExactTaylor<K> c = exact_taylor<K>(exact, u, v);
    const Rational s(random_pairs::integer(generator, 0, 8), 8), t(random_pairs::integer(generator, 0, 8), 8);
    const auto there = summed<K>(c, s - u, t - v);
    const Point expected = patch(s, t);
    for (std::size_t row = 0; row < 3; ++row) {
      if constexpr (K::weighted) {
        CHECK(there[row] == expected[row] * there[3]);
      } else {
        CHECK(there[row] == expected[row]);
      }
    }
  }
}

}  // namespace

TEST_CASE("exact Taylor coefficients: summed elsewhere they are the patch, of every kind", "[filter]") {
  check<Bicubic>(20311);
  check<WeightedBiquadratic>(20312);
  check<WeightedBicubic>(20313);
}

TEST_CASE("exact Taylor coefficients: of a biquadratic patch about its middle", "[filter]") {
  // (u, v, u^2 v): u = 1/2 + h, v = 1/2 + k.
  ControlNet net{};
  net[1][0][0] = 1;
  net[0][1][1] = 1;
  net[2][1][2] = 1;
  const Rational half(1, 2);
  const auto c = exact_taylor<Biquadratic>(BezierPatch::from_power_basis(net), half, half);
  CHECK(c[0] == std::array<Rational, 3>{half, half, Rational(1, 8)});
  CHECK(c[1] == std::array<Rational, 3>{0, 1, Rational(1, 4)});
  CHECK(c[3] == std::array<Rational, 3>{1, 0, half});
  CHECK(c[4] == std::array<Rational, 3>{0, 0, 1});
  CHECK(c[6] == std::array<Rational, 3>{0, 0, half});
  CHECK(c[7] == std::array<Rational, 3>{0, 0, 1});
  CHECK(c[8] == std::array<Rational, 3>{0, 0, 0});
}

}  // namespace exsect::exact_taylor_test
