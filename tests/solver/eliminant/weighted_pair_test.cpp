#include "eliminant/weighted_pair.h"

#include "support/catch.h"
#include "weighted_pairs.h"

namespace exsect::weighted_pair_test {
using namespace exsect::weighted_pairs;

namespace {

HomogeneousPoint value(const WeightedPair::Net& net, const Rational& u, const Rational& v) {
  HomogeneousPoint sum = {};
  const std::array<Rational, 3> powers_u = {1, u, u * u}, powers_v = {1, v, v * v};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 4; ++k) sum[k] += powers_u[i] * powers_v[j] * Rational(net[i][j][k]);
  return sum;
}

Integer content(const WeightedPair::Net& net) {
  Integer result = 0;
  for (const auto& row : net)
    for (const auto& c : row)
      for (const Integer& coordinate : c) result = gcd(result, coordinate);
  return result;
}

}  // namespace

TEST_CASE("weighted pair: the same points up to one diagonal map of space", "[weighted_pair]") {
  Random random(5);
  for (int repeat = 0; repeat < 4; ++repeat) {
    const RationalPatch x = weighted_patch(random), y = weighted_doubles(random);
    const WeightedPair pair = weighted_pair(x, y);
    CHECK(content(pair.x) == 1);
    CHECK(content(pair.y) == 1);
    const Point origin = x(0, 0);
    std::array<std::optional<Rational>, 3> scale;
    const auto check = [&](const RationalPatch& patch, const WeightedPair::Net& net) {
      for (const auto& [u, v] : std::vector<std::pair<Rational, Rational>>{
               {0, 0}, {1, 0}, {Rational(1, 3), Rational(2, 7)}, {Rational(4, 5), 1}}) {
        const Point p = patch(u, v);
        const HomogeneousPoint q = value(net, u, v);
        REQUIRE(sign(q[3]) > 0);
        for (std::size_t k = 0; k < 3; ++k) {
          if (p[k] == origin[k]) {
            CHECK(q[k] == 0);
            continue;
          }
          const Rational ratio = q[k] / q[3] / (p[k] - origin[k]);
          if (!scale[k]) scale[k] = ratio;
          CHECK(ratio == *scale[k]);
          CHECK(sign(ratio) > 0);
        }
      }
    };
    check(x, pair.x);
    check(y, pair.y);
  }
}

TEST_CASE("weighted pair: factors of the homogeneous nets disappear, places too", "[weighted_pair]") {
  Random random(6);
  const RationalPatch x = weighted_patch(random), y = weighted_patch(random);
  const WeightedPair pair = weighted_pair(x, y);
  const auto times = [](const HomogeneousPoint& p) {
    return HomogeneousPoint{p[0] * 7 / 3, p[1] * 7 / 3, p[2] * 7 / 3, p[3] * 7 / 3};
  };
  const auto far = [](const HomogeneousPoint& p) {
    return HomogeneousPoint{p[0] + 100000000 * p[3], p[1], p[2] - p[3] / 3, p[3]};
  };
  for (const WeightedPair& same : {weighted_pair(mapped(x, times), y), weighted_pair(x, mapped(y, times)),
                                   weighted_pair(mapped(x, far), mapped(y, far))}) {
    CHECK(same.x == pair.x);
    CHECK(same.y == pair.y);
  }
}

}  // namespace exsect::weighted_pair_test
