// Polynomial maps and their derivatives, compared with sums of terms.
#include <exsect/checker/map.h>

#include <algorithm>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::map_test {
namespace {

using Map = checker::Map<Rational>;
using Place = checker::Vector4<Rational>;
using Point = checker::Vector3<Rational>;
using Generator = random_pairs::Generator;

Rational some(Generator& generator) { return Rational(random_pairs::integer(generator, -20, 20), 7); }

/// Some monomials, with all that divide them.
Map random_map(Generator& generator, int monomials) {
  Map map;
  for (int n = 0; n < monomials; ++n) {
    checker::Power power;
    for (int& exponent : power) exponent = static_cast<int>(random_pairs::integer(generator, 0, 4));
    map.add(power, {some(generator), some(generator), some(generator)}, 1);
  }
  return map;
}

/// The derivative of w^power, a_j times to w_j.
Rational monomial(const Place& w, const checker::Power& power, const checker::Power& a = {}) {
  Rational result = 1;
  for (std::size_t j = 0; j < 4; ++j) {
    for (int n = 0; n < a[j]; ++n) result *= power[j] - n;
    for (int n = a[j]; n < power[j]; ++n) result *= w[j];
  }
  return result;
}

Point value(const Map& map, const Place& w) {
  Point sum = {};
  for (const auto& term : map.terms())
    for (std::size_t d = 0; d < 3; ++d) sum[d] += term.c[d] * monomial(w, term.power);
  return sum;
}

/// The range over |dw| <= half as a sum over the terms.
checker::Balls<Rational> derivative(const Map& map, const checker::Power& a, const Place& half) {
  checker::Balls<Rational> result;
  for (const auto& term : map.terms()) {
    const Rational size = monomial(half, term.power, a);
    for (std::size_t d = 0; d < 3; ++d)
      term.power == a ? result[d].middle += size * term.c[d] : result[d].radius += abs(size * term.c[d]);
  }
  return result;
}

bool equal(const checker::Balls<Rational>& a, const checker::Balls<Rational>& b) {
  bool result = true;
  for (std::size_t d = 0; d < 3; ++d)
    result = result && a[d].middle == b[d].middle && a[d].radius == b[d].radius;
  return result;
}

}  // namespace

TEST_CASE("Taylor coefficients at another point are those of the same map") {
  Generator generator(56);
  INFO("seed 56");
  for (int i = 0; i < 30; ++i) {
    INFO(i);
    const Map map = random_map(generator, i % 6);
    Place w = {some(generator), some(generator), some(generator), some(generator)};
    if (i % 3 == 0) w[static_cast<std::size_t>(i) % 4] = 0;
    const Place further = {some(generator), 0, some(generator), 1};
    const Place sum = {w[0] + further[0], w[1] + further[1], w[2] + further[2], w[3] + further[3]};
    CHECK(map.value(w) == value(map, w));
    CHECK(map.at(w).value(further) == value(map, sum));
    CHECK(map.at(w).terms().size() == map.terms().size());
  }
}

TEST_CASE("ranges over a box are the sums of their terms") {
  Generator generator(58);
  INFO("seed 58");
  const Place half = {Rational(1, 3), Rational(2, 5), 0, Rational(1, 7)};
  for (int i = 0; i < 30; ++i) {
    INFO(i);
    const Map map = random_map(generator, i % 6);
    const checker::Ranges over(map, half);
    CHECK(equal(over.value(), derivative(map, {}, half)));
    checker::Box<Rational> t;
    for (auto& ball : t) ball = {some(generator), abs(some(generator))};
    checker::Balls<Rational> second;
    for (std::size_t j = 0; j < 4; ++j) {
      checker::Power a = {};
      a[j] = 1;
      CHECK(equal(over.first(j), derivative(map, a, half)));
      for (std::size_t d = 0; d < 3; ++d) CHECK(map.slope(j)[d] == over.first(j)[d].middle);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = j; k < 4; ++k) {
        checker::Power a = {};
        ++a[j], ++a[k];
        const auto entry = derivative(map, a, half);
        const checker::Ball<Rational> both = t[j] * t[k];
        for (std::size_t d = 0; d < 3; ++d)
          second[d] = second[d] + checker::Ball<Rational>(j == k ? 1 : 2) * entry[d] * both;
      }
    }
    CHECK(equal(over.second(t), second));
  }
}

TEST_CASE("F of patches with weights has a term for each pair of monomials, of others for each of either") {
  Generator generator(57);
  INFO("seed 57");
  const auto nets = random_nets::scattered(generator, {3, 3, 3, 3});
  checker::WeightedNet<Rational> x = {checker::Net<Rational>(3, 3)};
  x.points.each([&](std::size_t i, std::size_t j) { x.points[i][j] = nets.x[i][j]; });
  CHECK(checker::pair_map(x, x).terms().size() == 31);
  checker::WeightedNet<Rational> y = x;
  y.weights = checker::Grid<Rational, 1>(3, 3);
  y.weights.each([&](std::size_t i, std::size_t j) { y.weights[i][j][0] = static_cast<long>(1 + i + j); });
  CHECK(checker::pair_map(x, y).terms().size() == 256);
}

}  // namespace exsect::map_test
