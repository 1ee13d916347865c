#include <exsect/checker/walls.h>
#include <exsect/geometry/number.h>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::walls_test {
namespace {

using checker::Box;
using checker::Factor;
using checker::Map;
using checker::Power;
using checker::Vector3;
using checker::Vector4;
using random_pairs::Generator;
using Place = Vector4<Rational>;

Rational small(Generator& generator) { return Rational(random_pairs::integer(generator, -5, 5), 4); }
Rational inside(Generator& generator) { return Rational(random_pairs::integer(generator, 0, 16), 16); }

Power variable(std::size_t i) {
  Power power = {};
  power[i] = 1;
  return power;
}

/// g = (c (u - a), s - v, d (r - b)), a and b 0 or 1, beginning with any of the three.
Factor random_factor(Generator& generator) {
  Factor result = {{}, {1, 1, 1}, {}};
  const auto order = static_cast<std::size_t>(random_pairs::integer(generator, 0, 2));
  const auto row = [&](std::size_t j) {
    Vector3<Rational> unit = {};
    unit[(j + order) % 3] = 1;
    return unit;
  };
  for (const std::size_t j : {0, 2}) {
    const Rational c = random_pairs::integer(generator, 0, 1) == 0 ? Rational(-2) : Rational(3, 2);
    result.map.add(variable(j), row(j), c);
    if (random_pairs::integer(generator, 0, 1) == 1) result.map.add(Power{}, row(j), -c);
  }
  result.map.add(variable(3), row(1), 1);
  result.map.add(variable(1), row(1), -1);
  for (Map<Rational>& column : result.columns)
    for (std::size_t i = 0; i < 5; ++i)
      column.add(i < 4 ? variable(i) : Power{}, {small(generator), small(generator), small(generator)},
                 i < 4 ? Rational(1, 8) : Rational(1));
  if (random_pairs::integer(generator, 0, 3) == 0)
    result.powers[static_cast<std::size_t>(random_pairs::integer(generator, 0, 2))] = 2;
  return result;
}

Rational powered(const Rational& g, std::size_t n) { return n == 1 ? g : Rational(g * g); }

Vector3<Rational> value(const Factor& factor, const Place& w) {
  const Vector3<Rational> g = factor.map.value(w);
  Vector3<Rational> sum = {};
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector3<Rational> m = factor.columns[j].value(w);
    for (std::size_t d = 0; d < 3; ++d) sum[d] += m[d] * powered(g[j], factor.powers[j]);
  }
  return sum;
}

Box<Rational> around(const Place& w, const Rational& radius) {
  Box<Rational> box;
  for (std::size_t i = 0; i < 4; ++i) box[i] = {w[i], radius};
  return box;
}

}  // namespace

TEST_CASE("walls: of three the first one is the other component, as in examples/check_certificate.py") {
  // x = (u, v, 0) and y = (1 + r, -r, r^2 s), which begins in the corner (1,0) of x.
  Factor factor = {{}, {1, 1, 1}, {}};
  for (const std::size_t j : {0, 1, 2}) {
    Vector3<Rational> unit = {};
    unit[j] = 1;
    factor.map.add(variable(j), unit, 1);
    if (j == 0) factor.map.add(Power{}, unit, -1);
    if (j < 2) factor.columns[j].add(Power{}, unit, 1);
  }
  factor.columns[2].add(Power{}, {-1, 1, 0}, 1);
  factor.columns[2].add(Power{0, 0, 1, 1}, {0, 0, -1}, 1);
  const auto walls = checker::walls_of(factor);
  REQUIRE(walls.has_value());
  CHECK(walls->other() == 0);
  CHECK(checker::is_singular_along(factor, *walls));
  const Box<Rational> whole =
      around({Rational(1, 2), Rational(1, 2), Rational(1, 2), Rational(1, 2)}, Rational(1, 2));
  CHECK(checker::on_one_side(factor, *walls, factor.columns, whole));
}

TEST_CASE("walls are multiples of a parameter minus 0 or 1") {
  const auto of = [](const std::vector<std::pair<Power, Rational>>& terms) {
    Map<Rational> map;
    for (const auto& [power, c] : terms) map.add(power, {1, 0, 0}, c);
    return checker::wall(map, 0);
  };
  const auto low = of({{{0, 1, 0, 0}, -3}});
  REQUIRE(low);
  CHECK((low->first.parameter == 1 && low->first.value == 0 && low->second == -1));
  const auto high = of({{{0, 0, 1, 0}, 2}, {{}, -2}});
  REQUIRE(high);
  CHECK((high->first.parameter == 2 && high->first.value == 1 && high->second == -1));
  CHECK(!of({{{1, 0, 0, 0}, 2}, {{}, -1}}));
  CHECK(!of({{{1, 0, 0, 0}, 1}, {{}, 1}}));
  CHECK(!of({{{1, 0, 0, 0}, 1}, {{0, 1, 0, 0}, -1}}));
  CHECK(!of({{{2, 0, 0, 0}, 1}, {{}, -1}}));
  CHECK(!of({{{1, 0, 0, 0}, 1}, {{0, 0, 1, 0}, 1}, {{}, -1}}));
  CHECK(!of({{{}, 1}}));
  CHECK(!of({}));
}

TEST_CASE("a factor has walls only if its third component is a graph on them") {
  Factor factor = {{}, {1, 1, 1}, {}};
  for (auto& column : factor.columns) column.add(Power{}, {1, 2, 3}, 1);
  factor.map.add(variable(0), {1, 0, 0}, 1);
  factor.map.add(variable(2), {0, 1, 0}, 1);
  factor.map.add({0, 1, 0, 1}, {0, 0, 1}, 1);  // v s, two curves
  CHECK(!checker::walls_of(factor));
  factor.map.add(variable(1), {0, 0, 1}, 1);  // v s + v, the same
  CHECK(!checker::walls_of(factor));
  factor.map.add({0, 1, 0, 1}, {0, 0, 1}, -1);
  factor.map.add({0, 0, 0, 2}, {0, 0, 1}, 5);  // v + 5 s^2
  CHECK(checker::walls_of(factor));
  factor.map.add({3, 1, 0, 0}, {0, 0, 1}, 5);  // and what is 0 on the walls
  CHECK(checker::walls_of(factor));
  factor.columns[2] = {};
  CHECK(!checker::walls_of(factor));
}

TEST_CASE("on one side of a plane there is nothing but the curve") {
  Generator generator(1917);
  INFO("seed 1917");
  int proved = 0, forged = 0;
  for (int n = 0; n < 3000; ++n) {
    Factor factor = random_factor(generator);
    const auto walls = checker::walls_of(factor);
    REQUIRE(walls);
    const Place w = {inside(generator), inside(generator), inside(generator), inside(generator)};
    const Box<Rational> box = around(w, Rational(1, 8));
    if (checker::on_one_side(factor, *walls, factor.columns, box)) {
      ++proved;
      for (int i = 0; i < 10; ++i) {
        Place at;
        for (std::size_t k = 0; k < 4; ++k)
          at[k] = std::clamp<Rational>(w[k] + (inside(generator) - Rational(1, 2)) / 4, 0, 1);
        const bool zero = value(factor, at) == Vector3<Rational>{};
        REQUIRE(zero == (factor.map.value(at) == Vector3<Rational>{}));
      }
    }
    // With a solution off the curve, forged into one of the columns, it must not be proved.
    const Vector3<Rational> g = factor.map.value(w);
    const Vector3<Rational> f = value(factor, w);
    for (std::size_t j = 0; j < 3; ++j) {
      if (g[j] == 0) continue;
      Factor other = factor;
      other.columns[j].add(Power{}, f, -1 / powered(g[j], factor.powers[j]));
      REQUIRE(value(other, w) == Vector3<Rational>{});
      CHECK(!checker::on_one_side(other, *walls, other.columns, box));
      ++forged;
    }
  }
  CHECK(proved > 100);
  CHECK(forged > 2000);
}

TEST_CASE("the patches touch along the curve where the determinant of the columns vanishes on it") {
  Generator generator(1918);
  INFO("seed 1918");
  for (int n = 0; n < 200; ++n) {
    Factor factor = random_factor(generator);
    factor.powers = {1, 1, 1};
    const auto walls = checker::walls_of(factor);
    REQUIRE(walls);
    const std::size_t a = walls->components[0], b = walls->components[1], c = walls->other();
    const bool made = n % 2 == 0;
    if (made) {  // M_b = M_a + 3 M_c on the curve v = s, but not elsewhere
      factor.columns[b] = factor.columns[a];
      for (const auto& term : factor.columns[c].terms()) factor.columns[b].add(term.power, term.c, 3);
      const Vector3<Rational> extra = {1, small(generator), 2};
      factor.columns[b].add(variable(1), extra, 1);
      factor.columns[b].add(variable(3), extra, -1);
    }
    bool singular = true;
    for (int i = 0; i < 8; ++i) {
      Place at = {0, Rational(i, 7), 0, Rational(i, 7)};
      for (const checker::Side& side : walls->sides) at[side.parameter] = side.value;
      const auto m = [&](std::size_t j) { return factor.columns[j].value(at); };
      singular = singular && checker::dot(m(a), checker::cross(m(b), m(c))) == 0;
    }
    CHECK(checker::is_singular_along(factor, *walls) == singular);
    CHECK(checker::touches(factor) == singular);
    CHECK((singular || !made));
  }
}

}  // namespace exsect::walls_test
