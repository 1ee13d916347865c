#include "eliminant/vector_eliminant.h"

#include <exsect/algebra/modular.h>
#include <exsect/solver/turning_eliminant.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "eliminant/eliminant_height.h"
#include "eliminant/turning_eliminant_lanes.h"
#include "eliminant/turning_eliminant_modular.h"
#include "eliminant_pairs.h"
#include "support/catch.h"

namespace exsect::vector_eliminant_test {
using namespace exsect::eliminant_pairs;

namespace {

/// E by the scalar code, with Euclid's algorithm for every sequence of degrees.
std::vector<Integer> scalar_eliminant(const IntegerPair& pair, std::size_t bits) {
  return interpolate_integer_polynomial(
      128, bits, [&](const PrimeField& field, Residue u, std::size_t count) {
        const ModularEliminant eliminant(field, pair);
        std::vector<ResidueFraction> values;
        for (std::size_t i = 0; i < count; ++i, u = field.add(u, field.one()))
          values.push_back(eliminant.value(u));
        return values;
      });
}

}  // namespace

TEST_CASE("the primes below 2^48 are the primes below 2^48", "[vector_eliminant]") {
  LanePrimes primes;
  std::uint64_t p = std::uint64_t{1} << 48;
  for (int i = 0; i < 200; ++i) {
    p = prime_below(p);
    CHECK(primes.next() == p);
  }
}

#ifdef __x86_64__

namespace {

using LaneWord = std::array<std::uint64_t, 4>;

LaneWord some_primes(std::size_t skip) {
  LanePrimes primes;
  for (std::size_t i = 0; i < skip; ++i) primes.next();
  return {primes.next(), primes.next(), primes.next(), primes.next()};
}

/// Of the kinds of integers of modulus at most p/2, those next to 0 and to the ends, and random ones.
double awkward_residue(std::uint64_t p, int kind, std::mt19937_64& random) {
  const auto half = static_cast<double>(p / 2);
  switch (kind) {
    case 0:
      return half;
    case 1:
      return -half;
    case 2:
      return (random() & 1) == 0 ? half : -half;
    case 3:
      return static_cast<double>(random() % 3) - 1;
    case 4:
      return half - static_cast<double>(random() % 4);
    default:
      return static_cast<double>(random() % p) - half;
  }
}

std::uint64_t representative(double a, std::uint64_t p) {
  REQUIRE(std::abs(a) <= 0.61 * static_cast<double>(p));
  REQUIRE(a == std::trunc(a));
  return a < 0 ? p - static_cast<std::uint64_t>(-a) : static_cast<std::uint64_t>(a);
}

Residue residue(const PrimeField& field, double a) { return field.residue(static_cast<std::int64_t>(a)); }

LanePair<PolynomialKind> awkward_pair(const LaneWord& primes, int kind, std::mt19937_64& random) {
  LanePair<PolynomialKind> pair;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    pair.primes[lane] = static_cast<double>(primes[lane]);
    for (auto* net : {&pair.x, &pair.y})
      for (auto& row : *net)
        for (auto& point : row)
          for (auto& c : point) c[lane] = awkward_residue(primes[lane], kind, random);
  }
  return pair;
}

IntegerPair integers(const LanePair<PolynomialKind>& pair, std::size_t lane) {
  IntegerPair result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        result.x[i][j][k] = static_cast<std::int64_t>(pair.x[i][j][k][lane]);
        result.y[i][j][k] = static_cast<std::int64_t>(pair.y[i][j][k][lane]);
      }
  return result;
}

/// What eliminant_in_lanes promises for one prime, by the scalar code; empty if a value is undefined.
std::vector<Residue> coefficients_by_scalars(const PrimeField& field, const IntegerPair& pair, double first,
                                             std::size_t points) {
  const ModularEliminant eliminant(field, pair);
  std::vector<Residue> values;
  for (const ResidueFraction& value : eliminant.fast_values(residue(field, first), points)) {
    if (value.denominator == 0) return {};
    values.push_back(field.multiply(value.numerator, field.inverse(value.denominator)));
  }
  return interpolate(field, residue(field, first), values);
}

}  // namespace

TEST_CASE("interpolation in lanes agrees with interpolation modulo one prime", "[vector_eliminant]") {
  if (!has_vector_eliminant()) return;
  std::mt19937_64 random(11);
  const std::vector<std::size_t> sizes = {1, 2, 3, 4, 5, 6, 7, 8, 9, 64, 129, 138, max_lane_points};
  for (const std::size_t points : sizes)
    for (int kind = 0; kind < 6; ++kind) {
      INFO("points " << points << ", kind " << kind);
      const LaneWord primes = some_primes(random() % 190);
      double p[4];
      double first[4];
      double values[max_lane_points][4];
      std::vector<std::vector<Residue>> expected;
      for (std::size_t lane = 0; lane < 4; ++lane) {
        p[lane] = static_cast<double>(primes[lane]);
        first[lane] = awkward_residue(primes[lane], 5 - kind, random);
        const PrimeField field(primes[lane]);
        std::vector<Residue> column;
        for (std::size_t i = 0; i < points; ++i) {
          values[i][lane] = awkward_residue(primes[lane], kind, random);
          column.push_back(residue(field, values[i][lane]));
        }
        expected.push_back(interpolate(field, residue(field, first[lane]), column));
      }
      interpolate_in_lanes(p, first, points, values);
      for (std::size_t lane = 0; lane < 4; ++lane) {
        const PrimeField field(primes[lane]);
        bool equal = true;
        for (std::size_t i = 0; i < points; ++i)
          equal = equal &&
                  representative(values[i][lane], primes[lane]) == field.representative(expected[lane][i]);
        CHECK(equal);
      }
    }
}

TEST_CASE("the eliminant in lanes agrees with the eliminant modulo one prime", "[vector_eliminant]") {
  if (!has_vector_eliminant()) return;
  std::mt19937_64 random(12);
  int compared = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const LaneWord primes = some_primes(random() % 190);
    LanePair<PolynomialKind> pair = awkward_pair(primes, trial % 6, random);
    if (trial % 6 == 2)  // undefined for one prime alone
      for (auto& row : pair.x)
        for (auto& point : row)
          for (auto& c : point) c[1] = 0;
    const std::size_t points = trial < 12 ? 7 : 20;
    double first[4];
    for (std::size_t lane = 0; lane < 4; ++lane)
      first[lane] = awkward_residue(primes[lane], trial % 5, random);
    double coefficients[max_lane_points][4];
    bool defined[4];
    eliminant_in_lanes(pair, first, points, coefficients, defined);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      INFO("trial " << trial << ", lane " << lane);
      const PrimeField field(primes[lane]);
      const auto expected = coefficients_by_scalars(field, integers(pair, lane), first[lane], points);
      CHECK(defined[lane] == !expected.empty());
      if (expected.empty()) continue;
      ++compared;
      bool equal = true;
      for (std::size_t i = 0; i < points; ++i)
        equal =
            equal && representative(coefficients[i][lane], primes[lane]) == field.representative(expected[i]);
      CHECK(equal);
    }
  }
  CHECK(compared >= 40);
}

TEST_CASE("the eliminants of pairs of patches by vector and by scalar code are equal", "[vector_eliminant]") {
  if (!has_vector_eliminant()) return;
  Random random(13);
  for (int trial = 0; trial < 6; ++trial) {
    INFO("trial " << trial);
    const auto coordinate = [&] {
      return trial % 2 == 0 ? small_rational(random)
                            : from_double(std::uniform_real_distribution<double>(-1, 1)(random));
    };
    const IntegerPair pair = integer_pair(BezierPatch(net_of(coordinate)), BezierPatch(net_of(coordinate)));
    const std::size_t bits = eliminant_height_bound(pair);
    const auto e = vector_eliminant(pair, bits);
    REQUIRE(e.has_value());
    CHECK(chinese_remainder(*e) == scalar_eliminant(pair, bits));
  }
}

TEST_CASE("the vector code leaves to the scalar code what it cannot divide", "[vector_eliminant]") {
  IntegerPair pair;  // everything zero
  CHECK_FALSE(vector_eliminant(pair, 100).has_value());
  // A surface with equal coefficients of r^2 and s^2: lc(S1) vanishes for all u.
  Random random(14);
  ControlNet c = random_net(random);
  c[2][2] = Point{};
  const IntegerPair special = integer_pair(random_patch(random), BezierPatch::from_power_basis(c));
  CHECK_FALSE(vector_eliminant(special, 100).has_value());
}

#endif

}  // namespace exsect::vector_eliminant_test
