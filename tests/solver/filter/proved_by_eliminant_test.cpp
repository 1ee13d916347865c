// Pairs that come nearer than doubles tell: the eliminant decides what the search does not.
#include "filter/proved_by_eliminant.h"

#include <exsect/solver/intersect_rational.h>

#include <algorithm>

#include "eliminant/weighted_eliminant.h"
#include "solver/eliminant/weighted_pairs.h"
#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::proved_by_eliminant_test {
namespace {

using namespace exsect::weighted_pairs;

/// Of bidegrees (m,n).
struct Shape {
  int m, n;
  bool weighted;
};

/// Near the graph of `bend` times a bump over the unit square, straight along a parameter of degree 1.
RationalPatch bent(Random& random, const Shape& shape, const Rational& bend) {
  std::vector<std::vector<Point>> points(static_cast<std::size_t>(shape.m + 1));
  std::vector<std::vector<Rational>> weights(points.size());
  for (int i = 0; i <= shape.m; ++i)
    for (int j = 0; j <= shape.n; ++j) {
      const long inner = (0 < i && i < shape.m ? 1 : 0) + (0 < j && j < shape.n ? 1 : 0);
      const auto row = static_cast<std::size_t>(i);
      points[row].push_back({Rational(i, shape.m) + small_rational(random) / 16,
                             Rational(j, shape.n) + small_rational(random) / 16,
                             bend * inner / 2 + small_rational(random) / 16});
      const Rational weight(std::uniform_int_distribution<int>(12, 24)(random), 16);
      weights[row].push_back(shape.weighted ? weight : Rational(1));
    }
  return RationalPatch(points, weights);
}

struct Jet {
  HomogeneousPoint value, first, second;
};
Jet jet(const PowerBasis& c, const Rational& u, const Rational& v) {
  const std::array<Rational, 4> powers_u = {1, u, u * u, u * u * u}, powers_v = {1, v, v * v, v * v * v};
  const std::array<Rational, 4> slopes_u = {0, 1, 2 * u, 3 * u * u}, slopes_v = {0, 1, 2 * v, 3 * v * v};
  Jet sum = {};
  for (std::size_t i = 0; i < c.size(); ++i)
    for (std::size_t j = 0; j < c[i].size(); ++j)
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
TouchingPair touching_pair(std::uint64_t seed, const Shape& first, const Shape& second) {
  Random random(seed);
  const RationalPatch x = bent(random, first, 1);
  PowerBasis y = power_basis(bent(random, second, -1));
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

template <class K>
bool is_proved(const RationalPatch& x, const RationalPatch& y, const filter::KnownStations& known) {
  const auto first = filter::elevated<K>(x), second = filter::elevated<K>(y);
  const auto pair = filter::make_pair_of<K>(first, second);
  REQUIRE(pair);
  filter::TreesOf<K> trees{filter::PatchTreeOf<K>(pair->x, pair->net_error),
                           filter::PatchTreeOf<K>(pair->y, pair->net_error)};
  long boxes = 0;
  return filter::proved_by_eliminant<K>(first, second, *pair, {}, known, trees, boxes);
}

}  // namespace

TEST_CASE("proved by the eliminant: patches that are 2^-40 to 2^-100 apart", "[proved_by_eliminant]") {
  using Pair = std::pair<Shape, Shape>;
  for (const auto& [first, second] :
       {Pair{{2, 2, true}, {2, 2, true}}, Pair{{2, 1, true}, {1, 2, false}}, Pair{{2, 2, true}, {1, 2, true}},
        Pair{{3, 1, false}, {1, 3, false}}, Pair{{3, 1, true}, {2, 2, false}},
        Pair{{2, 1, true}, {3, 2, true}}, Pair{{3, 3, false}, {1, 3, true}}}) {
    CAPTURE(first.m, first.n, second.m, second.n);
    const TouchingPair pair = touching_pair(1, first, second);
    for (const int exponent : {-40, -70, -100}) {
      INFO("2^" << exponent);
      const IntersectResult apart = intersect(pair.x, pair.moved(power_of_two(exponent)));
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

/// At the place where they touch.
filter::KnownStations touch() {
  const std::array<Rational, 4> at = {Rational(1, 2), Rational(2, 5), Rational(4, 9), Rational(3, 7)};
  filter::KnownStations known;
  for (std::size_t p = 0; p < 4; ++p) {
    const RationalInterval place = {at[p], at[p]};
    known.curves[p].push_back({{place, place}, false});
    known.singular[p].push_back(place);
  }
  return known;
}

TEST_CASE("proved by the eliminant: a touch point explains its double root", "[proved_by_eliminant]") {
  const auto check = [](auto kind, const Shape& first, const Shape& second) {
    using K = decltype(kind);
    CAPTURE(first.m, first.n, second.m, second.n);
    const TouchingPair pair = touching_pair(1, first, second);
    const RationalPatch y = pair.moved(0);
    for (const Parameter p : eliminant_sweeps(pair.x, y)) {
      const auto roots = weighted_turning_roots(pair.x, y, p);
      REQUIRE(roots);
      const RationalInterval place = touch().singular[index(p)].front();
      CHECK(std::ranges::count_if(*roots, [&](const EliminantRoot& root) {
              return root.order == 2 && root.at.lower <= place.lower && place.upper <= root.at.upper;
            }) == 1);
    }
    CHECK(is_proved<K>(pair.x, y, touch()));
    CHECK_FALSE(is_proved<K>(pair.x, y, {}));
    // Above each other, where no root explains a touch point.
    CHECK_FALSE(is_proved<K>(pair.x, pair.moved(Rational(1, 100)), touch()));
    IntersectOptions options;
    options.exact = true;
    const IntersectResult result = intersect(pair.x, y, options);
    CHECK(result.status == Status::complete);
    REQUIRE(result.graph.nodes.size() == 1);
    CHECK(result.graph.nodes.front().kinds == std::vector{NodeKind::touch});
  };
  check(filter::WeightedBiquadratic(), {2, 2, true}, {2, 2, true});
  check(filter::WeightedBiquadratic(), {2, 1, true}, {1, 2, false});
  check(filter::WeightedBicubic(), {3, 1, true}, {2, 2, false});
  check(filter::Bicubic(), {3, 1, false}, {1, 3, false});
}

template <class K>
void check_left_out(std::array<int, 4> degrees, bool weighted) {
  CAPTURE(degrees, weighted);
  int missed = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    random_nets::Generator generator(seed);
    const auto nets = random_nets::loop(generator, degrees);
    const RationalPatch x = weighted ? random_nets::weighted(generator, nets.x) : nets.first();
    const RationalPatch y = weighted ? random_nets::weighted(generator, nets.y) : nets.second();
    const IntersectResult result = intersect(x, y);
    if (result.status != Status::complete || result.graph.count(ComponentShape::open) > 0) continue;
    CHECK(is_proved<K>(x, y, {}) == result.graph.arcs.empty());
    missed += result.graph.arcs.empty() ? 0 : 1;
  }
  CHECK(missed >= 2);
}

TEST_CASE("proved by the eliminant: a closed curve that is left out", "[proved_by_eliminant]") {
  check_left_out<filter::WeightedBiquadratic>({2, 2, 2, 2}, true);
  check_left_out<filter::WeightedBiquadratic>({2, 2, 2, 1}, true);
  check_left_out<filter::WeightedBicubic>({3, 2, 1, 1}, true);
  check_left_out<filter::Bicubic>({2, 2, 1, 3}, false);
}

}  // namespace exsect::proved_by_eliminant_test
