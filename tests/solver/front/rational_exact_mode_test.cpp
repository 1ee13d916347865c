// Pairs of any bidegrees in exact mode: complete only where an eliminant proves it, with the graph that
// doubles find.
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <vector>

#include "solver/filter/round_patches.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace exsect::rational_exact_mode_test {
namespace {

using random_nets::Generator;
using Degrees = std::array<int, 4>;

constexpr std::array<Degrees, 8> kDegrees = {{{2, 2, 2, 2},
                                              {2, 1, 2, 2},
                                              {1, 3, 3, 1},
                                              {1, 2, 3, 2},
                                              {2, 2, 1, 3},
                                              {1, 1, 3, 3},
                                              {3, 3, 2, 1},
                                              {3, 1, 3, 3}}};

IntersectOptions exact_mode() {
  IntersectOptions options;
  options.exact = true;
  return options;
}

struct Pair {
  RationalPatch x, y;
};

Pair pair_of(Generator& generator, const random_nets::Nets& nets, bool weighted) {
  if (!weighted) return {nets.first(), nets.second()};
  return {random_nets::weighted(generator, nets.x), random_nets::weighted(generator, nets.y)};
}

/// 1 if both are complete, and then equal.
int compared(const Pair& pair, bool by_eliminant = true) {
  const IntersectResult quick = intersect(pair.x, pair.y);
  const IntersectResult exact = intersect(pair.x, pair.y, exact_mode());
  CHECK(exact.work.steps.count("filtered") == 0);
  if (quick.status != Status::complete || exact.status != Status::complete) {
    CHECK((exact.status == Status::complete || !exact.incomplete.empty()));
    return 0;
  }
  CHECK(exact.work.steps.count("turning eliminant ms") == (by_eliminant ? 1 : 0));
  CHECK(difference(quick.graph, exact.graph, {}).empty());
  return 1;
}

}  // namespace

TEST_CASE("rational exact mode: the graph that doubles find, proved by an eliminant") {
  for (const Degrees& degrees : kDegrees) {
    CAPTURE(degrees);
    int complete = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      INFO("seed " << seed);
      Generator generator(seed);
      const bool weighted = seed % 2 == 0 || degrees == kDegrees[0];
      const auto nets = seed % 3 == 0 ? random_nets::loop(generator, degrees)
                                      : random_nets::crossing(generator, degrees, seed > 3);
      complete += compared(pair_of(generator, nets, weighted));
    }
    CHECK(complete >= 4);
  }
}

TEST_CASE("rational exact mode: shared corners and sides") {
  for (const Degrees& degrees : kDegrees) {
    CAPTURE(degrees);
    int corners = 0, sides = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      INFO("seed " << seed);
      Generator generator(seed);
      auto nets = random_nets::crossing(generator, degrees, seed > 2);
      nets.y.front().front() = nets.x.front().front();
      corners += compared(pair_of(generator, nets, degrees == kDegrees[0]));
      if (degrees[1] != degrees[3]) continue;
      nets.y.front() = nets.x.front();
      sides += compared(pair_of(generator, nets, false));
    }
    CHECK(corners >= 2);
    CHECK((degrees[1] != degrees[3] || sides >= 1));
  }
}

TEST_CASE("rational exact mode: pieces of one surface, and equal patches") {
  Generator generator(3);
  const RationalPatch whole =
      random_nets::weighted(generator, random_nets::crossing(generator, {2, 2, 2, 2}, true).x);
  const RationalPatch left = whole.restricted_to(0, Rational(2, 3), 0, 1);
  const RationalPatch right = whole.restricted_to(Rational(1, 3), 1, 0, 1);
  CHECK(compared({left, right}, false) == 1);
  CHECK(compared({whole, whole.transposed()}, false) == 1);
  const Rational half(1, 2);
  const RationalPatch lower = whole.restricted_to(0, half, 0, half);
  CHECK(compared({lower, whole.restricted_to(half, 1, 0, half)}, false) == 1);
  CHECK(compared({lower, whole.restricted_to(1, half, half, 0).transposed()}, false) == 1);
  CHECK(compared({lower, whole.restricted_to(half, 1, half, 1)}, false) == 1);
}

TEST_CASE("rational exact mode: pieces of one bicubic patch, which has no eliminant") {
  Generator generator(3);
  const RationalPatch whole(random_nets::crossing(generator, {3, 3, 3, 3}, true).x);
  const Rational half(1, 2);
  const RationalPatch left = whole.restricted_to(0, half, 0, 1);
  CHECK(compared({left, whole.restricted_to(Rational(1, 3), 1, 0, 1)}, false) == 1);
  CHECK(compared({left, whole.restricted_to(half, 1, 0, 1)}, false) == 1);
  CHECK(compared({whole, whole.transposed()}, false) == 1);
}

TEST_CASE("rational exact mode: poles on the other patch, common ones, and beside it") {
  const Rational third(1, 3);
  // An octant of a sphere for a weight of 1: by its pole (0,0,1) with the parameter along this side free.
  const auto bulged = [&](const Rational& radius, const Point& at, const Rational& weight) {
    const std::vector<std::vector<Rational>> weights = {{1, 1, 2}, {1, weight, 2}, {2, 2, 4}};
    std::vector<std::vector<Point>> net = {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                           {{1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                                           {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
    for (auto& row : net)
      for (Point& p : row) p = radius * p + at;
    return RationalPatch(net, weights);
  };
  const auto octant = [&](const Rational& radius, const Point& at) { return bulged(radius, at, 1); };
  // With conics for parameter lines, so that it has no inverse: (0,0,height) is its middle.
  const auto plane_through = [&](const Point& normal, const Rational& height) {
    const auto at = [&](const Rational& a, const Rational& b) -> Point {
      return {a, b, height - (a * normal[0] + b * normal[1]) / normal[2]};
    };
    return RationalPatch(
        {{at(-7, -5), at(-7, 5)}, {at(Rational(3, 2), -5), at(Rational(-1, 2), 5)}, {at(6, -5), at(6, 5)}});
  };
  const auto has_pole = [](const Pair& pair) {
    return std::ranges::any_of(intersect(pair.x, pair.y, exact_mode()).graph.nodes,
                               [](const Node& node) { return !node.free.empty(); });
  };
  RationalPatch x = bulged(1, {0, 0, 0}, Rational(3, 2));  // which has no inverse either
  for (const Point& normal : {Point{1, -1, third}, Point{-3, 1, 2}, Point{0, 0, 1}, Point{1, 1, 3}}) {
    const bool touches = normal[0] == 0;
    const Pair pair = {touches ? octant(1, {0, 0, 0}) : x, plane_through(normal, 1)};
    CHECK(compared(pair, !touches) == 1);
    CHECK(compared({pair.y, pair.x}, !touches) == 1);
    CHECK(has_pole(pair));
    for (const long bits : {10, 30, 60})
      for (const long sign : {1, -1})
        CHECK_FALSE(has_pole({x, plane_through(normal, 1 + sign * power_of_two(-bits))}));
  }
  x = octant(1, {0, 0, 0});
  CHECK(compared({x, octant(2, {0, 0, -1})}) == 1);
  CHECK(has_pole({x, octant(2, {0, 0, -1})}));
  for (const long bits : {10, 30, 60}) CHECK_FALSE(has_pole({x, octant(2, {0, 0, power_of_two(-bits) - 1})}));
}

TEST_CASE("rational exact mode: surfaces of revolution") {
  const auto rotated = [](const RationalPatch& patch, std::uint64_t seed) {
    Generator generator(seed);
    return random_nets::image(patch, random_nets::projective_map(generator));
  };
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    INFO("seed " << seed);
    const RationalPatch torus = rotated(testing::torus(2, 1), seed);
    complete += compared({testing::torus(2, 1), torus});
    const RationalPatch sphere = testing::sphere(Rational(5, 2));
    complete += compared({sphere, torus}) + compared({torus, sphere});
    // The sphere covers its points twice: double roots, of which one or both are outside of the squares.
    Generator generator(seed);
    const random_nets::Nets nets = random_nets::crossing(generator, {2, 1, 2, 2}, false);
    const random_nets::ProjectiveMap through = {{{4, 0, 0, 0}, {0, 4, 0, -2}, {0, 0, 2, 0}, {0, 0, 0, 1}}};
    for (const random_nets::Net* net : {&nets.x, &nets.y})
      complete += compared({random_nets::image(random_nets::weighted(generator, *net), through), sphere});
  }
  CHECK(complete == 20);
}

TEST_CASE("rational exact mode: incomplete where patches touch along a curve") {
  Generator generator(3);
  const RationalPatch whole = random_nets::weighted(generator, random_nets::doubles(generator, 2, 2));
  const RationalPatch left = whole.restricted_to(0, Rational(1, 2), 0, 1);
  const RationalPatch right = whole.restricted_to(Rational(1, 2), 1, 0, 1);
  const IntersectResult result = intersect(left, right, exact_mode());
  CHECK(result.status == Status::incomplete);
  REQUIRE_FALSE(result.incomplete.empty());
  CHECK(result.incomplete.front().why.find("eliminant") != std::string::npos);
}

TEST_CASE("rational exact mode: pairs without an affordable eliminant are refused by their kinds") {
  Generator generator(5);
  const auto refused = [&](const Degrees& degrees, bool weighted) {
    const Pair pair = pair_of(generator, random_nets::crossing(generator, degrees, true), weighted);
    CHECK_THROWS_AS(intersect(pair.x, pair.y, exact_mode()), NotSupported);
  };
  refused({3, 3, 3, 3}, false);
  refused({2, 3, 2, 2}, true);
  const Pair pair = pair_of(generator, random_nets::crossing(generator, {2, 3, 3, 3}, true), true);
  CHECK_THROWS_WITH(
      intersect(pair.x, pair.y, exact_mode()),
      "not supported yet: exact arithmetic for bidegree (2,3) with weights and bidegree (3,3) with weights");
}

}  // namespace exsect::rational_exact_mode_test
