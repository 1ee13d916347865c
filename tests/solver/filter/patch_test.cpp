#include "filter/patch.h"

#include <cmath>
#include <vector>

#include "support/catch.h"
#include "support/random_nets.h"
#include "support/random_pairs.h"

namespace exsect::patch_test {
namespace {

using random_pairs::Generator;

Rational q(long a, long b) { return Rational(a, b); }

/// The scaled patch that filter::make_pair stands for, exactly, as coefficients of (u - a)^i (v - b)^j at
/// index 3 i + j: Taylor's formula by the binomial theorem.
std::array<Point, 9> exact_expansion(const BezierPatch& patch, const ModelFrame& frame, const Rational& a,
                                     const Rational& b) {
  ControlNet c = patch.power_basis();
  const Rational scale = power_of_two(-frame.exponent);
  std::array<Point, 9> result{};
  constexpr std::array<std::array<long, 3>, 3> binomial = {{{1, 0, 0}, {1, 1, 0}, {1, 2, 1}}};
  const auto power = [](const Rational& t, std::size_t n) {
    return n == 0 ? Rational(1) : n == 1 ? t : t * t;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    c[0][0][k] -= from_double(frame.origin[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t m = 0; m <= i; ++m) {
          for (std::size_t n = 0; n <= j; ++n) {
            result[3 * m + n][k] +=
                scale * c[i][j][k] * binomial[i][m] * binomial[j][n] * power(a, i - m) * power(b, j - n);
          }
        }
      }
    }
  }
  return result;
}

/// The largest error of a coefficient as a fraction of its bound.
double worst_fraction(const BezierPatch& patch, const filter::Patch& rounded, const ModelFrame& frame,
                      double h, double k) {
  const Rational half(1, 2);
  const auto exact = exact_expansion(patch, frame, from_double(h) + half, from_double(k) + half);
  const filter::Coefficients c = filter::expand(rounded, h, k);
  double worst = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double error = std::fabs(to_double(from_double(c[i][j]) - exact[i][j]));
      worst = std::max(worst, error / rounded.error[i]);
    }
  }
  return worst;
}

void check_expansions(const random_pairs::Pair& pair, Generator& generator) {
  const auto rounded = filter::make_pair(pair.x, pair.y);
  REQUIRE(rounded);
  for (int i = 0; i < 20; ++i) {
    const auto offset = [&] {
      const long edge = random_pairs::integer(generator, -2, 6);
      return edge == 0   ? 0.75
             : edge == 1 ? -0.75
             : edge == 2 ? 0x1p-60
                         : 1.5 * (static_cast<double>(generator() >> 11U) * 0x1p-53 - 0.5);
    };
    const double h = offset();
    const double k = offset();
    INFO("h = " << h << ", k = " << k);
    CHECK(worst_fraction(pair.x, rounded->x, rounded->frame, h, k) <= 1);
    CHECK(worst_fraction(pair.y, rounded->y, rounded->frame, h, k) <= 1);
  }
}

random_pairs::Pair moved(const random_pairs::Pair& pair, const Rational& scale, const Rational& shift) {
  const random_pairs::AffineMap map = {{Point{scale, 0, 0}, Point{0, scale, 0}, Point{0, 0, scale}},
                                       Point{shift, -shift, shift}};
  return {map(pair.x), map(pair.y)};
}

}  // namespace

TEST_CASE("filter patch: Taylor coefficients are within their bounds on awkward patches") {
  Generator generator(1);
  const random_pairs::Pair pair = random_pairs::scattered(generator);
  check_expansions(moved(pair, q(1, 3), q(1, 7)), generator);
  check_expansions(moved(pair, 1, 1000000), generator);
  check_expansions(moved(pair, q(1, 1000003), q(1000, 3)), generator);
  check_expansions(moved(pair, power_of_two(200), power_of_two(200) / 3), generator);
  check_expansions(moved(pair, power_of_two(-200) / 3, 0), generator);
  ControlNet saw{};  // every second difference is as large as it can be
  for (std::size_t i = 0; i < 9; ++i) {
    const Rational sign = i % 2 == 0 ? 1 : -1;
    saw[i / 3][i % 3] = Point{sign, sign * q(1, 3), sign * q(-5, 7)};
  }
  check_expansions({BezierPatch(saw), pair.y}, generator);
}

TEST_CASE("filter patch: Taylor coefficients are within their bounds on random patches") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    check_expansions(random_pairs::doubles(generator), generator);
    check_expansions(moved(random_pairs::scattered(generator), q(2, 9), q(5, 3)), generator);
  }
}

TEST_CASE("filter patch: weighted nets are rounded once, about an origin near by") {
  using K = filter::WeightedBiquadratic;
  for (const long shift : {0L, 1000000L}) {
    INFO("moved by " << shift);
    Generator generator(3);
    const random_pairs::Pair pair = moved(random_pairs::scattered(generator), q(2, 7), shift);
    const auto weighted = [&](const BezierPatch& patch) {
      random_nets::Net net;
      for (const auto& row : patch.net()) net.emplace_back(row.begin(), row.end());
      return filter::elevated<K>(random_nets::weighted(generator, net));
    };
    const auto x = weighted(pair.x), y = weighted(pair.y);
    const auto rounded = filter::make_pair_of<K>(x, y);
    REQUIRE(rounded);
    const ModelFrame& frame = rounded->frame;
    CHECK((frame.origin == std::array<double, 3>{}) == (shift == 0));
    for (std::size_t i = 0; i < K::count; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Rational exact =
            (y.points[i][c] - y.weights[i] * from_double(frame.origin[c])) * power_of_two(-frame.exponent);
        CHECK(abs(exact) <= 1);
        CHECK(abs(from_double(rounded->y.net[i][c]) - exact) <= abs(exact) * power_of_two(-53));
      }
      CHECK(rounded->y.net[i][3] == to_double(y.weights[i]));
    }
  }
}

TEST_CASE("filter patch: pairs out of range are left to the exact solution") {
  Generator generator(1);
  const random_pairs::Pair pair = random_pairs::scattered(generator);
  const auto declined = [&](const random_pairs::Pair& p) { return !filter::make_pair(p.x, p.y); };
  CHECK(declined(moved(pair, power_of_two(400), 0)));
  CHECK(declined(moved(pair, power_of_two(2000), 0)));
  CHECK(declined(moved(pair, power_of_two(-400), 0)));
  CHECK(declined(moved(pair, 0, 1)));
  CHECK(declined(moved(pair, 1, power_of_two(60))));
  CHECK_FALSE(declined(pair));
}

}  // namespace exsect::patch_test
