// Pairs with weights that come nearer than doubles tell: the eliminant decides what the search does not.
#include "filter/proved_by_eliminant.h"

#include <exsect/solver/intersect_rational.h>

#include "solver/eliminant/weighted_pairs.h"
#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::proved_by_eliminant_test {
namespace {

using filter::WeightedBiquadratic;
using namespace exsect::weighted_pairs;

/// Near the graph of `bend` times a bump over the unit square.
RationalPatch bent(Random& random, const Rational& bend) {
  std::vector<std::vector<Point>> points(3);
  std::vector<std::vector<Rational>> weights(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational a(static_cast<long>(i), 2), b(static_cast<long>(j), 2);
      points[i].push_back({a + small_rational(random) / 16, b + small_rational(random) / 16,
                           (i == 1 && j == 1 ? bend : Rational(0)) + small_rational(random) / 8});
      weights[i].push_back(Rational(std::uniform_int_distribution<int>(8, 32)(random), 16));
    }
  return RationalPatch(points, weights);
}

struct Jet {
  HomogeneousPoint value, first, second;
};
Jet jet(const PowerBasis& c, const Rational& u, const Rational& v) {
  const std::array<Rational, 3> powers_u = {1, u, u * u}, powers_v = {1, v, v * v};
  const std::array<Rational, 3> slopes_u = {0, 1, 2 * u}, slopes_v = {0, 1, 2 * v};
  Jet sum = {};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 4; ++k) {
        sum.value[k] += powers_u[i] * powers_v[j] * c[i][j][k];
        sum.first[k] += slopes_u[i] * powers_v[j] * c[i][j][k];
        sum.second[k] += powers_u[i] * slopes_v[j] * c[i][j][k];
      }
  return sum;
}

struct TouchingPair {
  RationalPatch x;
  PowerBasis y;

  /// y moved along the third axis.
  RationalPatch moved(const Rational& by) const {
    PowerBasis c = y;
    for (auto& row : c)
      for (HomogeneousPoint& p : row) p[2] += by * p[3];
    return from_power_basis(c);
  }
};

/// With a common tangent plane at (1/2,2/5,4/9,3/7): there they touch, the second one from above.
TouchingPair touching_pair(std::uint64_t seed) {
  Random random(seed);
  const RationalPatch x = bent(random, 1);
  PowerBasis y = power_basis(bent(random, -1));
  const Rational r(4, 9), s(3, 7);
  const Jet to = jet(power_basis(x), Rational(1, 2), Rational(2, 5));
  const Jet from = jet(y, r, s);
  for (std::size_t k = 0; k < 4; ++k) {
    y[1][0][k] += to.first[k] * Rational(9, 10) + to.second[k] / 7 - from.first[k];
    y[0][1][k] += to.second[k] * Rational(11, 10) - to.first[k] / 9 - from.second[k];
  }
  const Jet turned = jet(y, r, s);
  for (std::size_t k = 0; k < 4; ++k) y[0][0][k] += to.value[k] - turned.value[k];
  return {x, y};
}

bool is_proved(const RationalPatch& x, const RationalPatch& y,
               const std::array<std::vector<Stations>, 4>& stations) {
  using K = WeightedBiquadratic;
  const auto first = filter::elevated<K>(x), second = filter::elevated<K>(y);
  const auto pair = filter::make_pair_of<K>(first, second);
  REQUIRE(pair);
  filter::TreesOf<K> trees{filter::PatchTreeOf<K>(pair->x, pair->net_error),
                           filter::PatchTreeOf<K>(pair->y, pair->net_error)};
  long boxes = 0;
  return filter::proved_by_eliminant<K>(first, second, *pair, trees, stations, boxes);
}

}  // namespace

TEST_CASE("proved by the eliminant: patches that are 2^-44 and 2^-100 apart", "[proved_by_eliminant]") {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    INFO("seed " << seed);
    const TouchingPair pair = touching_pair(seed);
    for (const int exponent : {-44, -100}) {
      INFO("2^" << exponent);
      const RationalPatch y = pair.moved(power_of_two(exponent));
      const IntersectResult apart = intersect(pair.x, y);
      CHECK(apart.status == Status::complete);
      CHECK(apart.graph.arcs.empty());
      CHECK(apart.graph.nodes.empty());
      // A closed curve that no search finds must not be called absent.
      const IntersectResult small = intersect(pair.x, pair.moved(-power_of_two(exponent)));
      CHECK((small.status == Status::incomplete || small.graph.count(ComponentShape::closed) == 1));
    }
    const IntersectResult loop = intersect(pair.x, pair.moved(-power_of_two(-12)));
    REQUIRE(loop.status == Status::complete);
    CHECK(loop.graph.count(ComponentShape::closed) == 1);
  }
}

TEST_CASE("proved by the eliminant: a closed curve that is left out", "[proved_by_eliminant]") {
  int missed = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    random_nets::Generator generator(seed);
    const auto nets = random_nets::loop(generator, {2, 2, 2, 2});
    const RationalPatch x = random_nets::weighted(generator, nets.x);
    const RationalPatch y = random_nets::weighted(generator, nets.y);
    const IntersectResult result = intersect(x, y);
    if (result.status != Status::complete || result.graph.count(ComponentShape::open) > 0) continue;
    CHECK(is_proved(x, y, {}) == result.graph.arcs.empty());
    missed += result.graph.arcs.empty() ? 0 : 1;
  }
  CHECK(missed >= 2);
}

}  // namespace exsect::proved_by_eliminant_test
