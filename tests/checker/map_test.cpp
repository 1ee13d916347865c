// Taylor coefficients of polynomial maps, by Horner's rule and term by term.
#include <exsect/checker/map.h>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::map_test {
namespace {

using Map = checker::Map<Rational>;
using Place = checker::Vector4<Rational>;
using Generator = random_pairs::Generator;

Rational some(Generator& generator) { return Rational(random_pairs::integer(generator, -20, 20), 7); }

bool equal(const Map& a, const Map& b) {
  bool result = a.terms().size() == b.terms().size();
  for (std::size_t i = 0; result && i < a.terms().size(); ++i)
    result = a.terms()[i].power == b.terms()[i].power && a.terms()[i].c == b.terms()[i].c;
  return result;
}

}  // namespace

TEST_CASE("Taylor coefficients of long maps are those of short ones") {
  Generator generator(56);
  INFO("seed 56");
  for (int i = 0; i < 30; ++i) {
    INFO(i);
    Map map;  // some monomials, with all that divide them
    for (int n = 0; n <= i % 6; ++n) {
      checker::Power power;
      for (int& exponent : power) exponent = static_cast<int>(random_pairs::integer(generator, 0, 4));
      map.add(power, {some(generator), some(generator), some(generator)}, 1);
    }
    Map other = map;
    other.set_long(true);
    Place w = {some(generator), some(generator), some(generator), some(generator)};
    if (i % 3 == 0) w[static_cast<std::size_t>(i) % 4] = 0;
    const Place further = {some(generator), 0, some(generator), 1};
    CHECK(equal(map.at(w), other.at(w)));
    CHECK((other.at(w).is_long() && !map.at(w).is_long()));
    const Place sum = {w[0] + further[0], w[1] + further[1], w[2] + further[2], w[3] + further[3]};
    CHECK(other.at(w).value(further) == map.value(sum));
    const Place half = {Rational(1, 3), Rational(2, 5), 0, Rational(1, 7)};
    for (const checker::Power& a : {checker::Power{}, {1, 0, 0, 0}, {0, 1, 1, 0}, {0, 0, 0, 2}}) {
      const auto balls = map.derivative(a, half), others = other.derivative(a, half);
      for (std::size_t d = 0; d < 3; ++d)
        CHECK((balls[d].middle == others[d].middle && balls[d].radius == others[d].radius));
    }
    CHECK(equal(other.at(w).at(further), map.at(sum)));
  }
}

TEST_CASE("F of patches with weights is long, others are not, and rounding keeps it so") {
  Generator generator(57);
  INFO("seed 57");
  const auto nets = random_nets::scattered(generator, {3, 3, 3, 3});
  checker::WeightedNet<Rational> x = {checker::Net<Rational>(3, 3)};
  x.points.each([&](std::size_t i, std::size_t j) { x.points[i][j] = nets.x[i][j]; });
  const Map without = checker::pair_map(x, x);
  CHECK((!without.is_long() && without.terms().size() == 31));
  checker::WeightedNet<Rational> y = x;
  y.weights = checker::Grid<Rational, 1>(3, 3);
  y.weights.each([&](std::size_t i, std::size_t j) { y.weights[i][j][0] = static_cast<long>(1 + i + j); });
  const Map with = checker::pair_map(x, y);
  CHECK((with.is_long() && with.terms().size() == 256));
  CHECK(checker::rounded<checker::Enclosure>(with).at({}).is_long());
}

}  // namespace exsect::map_test
