// Laws that hold for every pair of patches, and agreement with the brute-force oracle, over random pairs.
#include <exsect/solver/intersect.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "intersect_exactly.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/oracle.h"
#include "support/random_pairs.h"

namespace exsect::intersect_property_test {
namespace {

using random_pairs::Generator;
using random_pairs::Pair;
using Family = Pair (*)(Generator&);

/// The oracle's boundary points and the graph's nodes on the boundary are the same points.
void check_boundary(const IntersectionGraph& graph, const oracle::Intersection& expected) {
  std::vector<const Node*> nodes;
  for (const Node& node : graph.nodes) {
    if (!node.on.empty()) nodes.push_back(&node);
  }
  CHECK(nodes.size() == expected.boundary_points.size());
  for (const oracle::Vector4& z : expected.boundary_points) {
    const auto near = [&](const Node* node) {
      return std::equal(z.begin(), z.end(), node->approx.begin(),
                        [](double a, double b) { return std::abs(a - b) < 1e-7; });
    };
    CAPTURE(z[0], z[1], z[2], z[3]);
    CHECK(std::count_if(nodes.begin(), nodes.end(), near) == 1);
  }
}

/// By the sweep: filter_test.cpp compares the solution in doubles with that.
IntersectResult intersect_exactly(const BezierPatch& x, const BezierPatch& y) {
  return intersect_exactly(x, y, {});
}

/// True if the oracle had no doubt.
bool agrees_with_oracle(const Pair& pair) {
  const auto expected = oracle::intersect(pair.x, pair.y);
  const auto result = intersect_exactly(pair.x, pair.y);
  if (result.status == Status::incomplete) {
    CAPTURE(result.incomplete.at(0).why, expected.doubt);
    CHECK(result.status == Status::complete);
    return expected.conclusive();
  }
  if (!expected.conclusive()) return false;
  CHECK(result.graph.count(ComponentShape::closed) == expected.closed());
  CHECK(result.graph.count(ComponentShape::open) == expected.open());
  CHECK(result.graph.count(ComponentShape::branched) == 0);
  CHECK(result.graph.isolated_points.empty());
  CHECK(result.graph.overlaps.empty());
  check_boundary(result.graph, expected);
  return true;
}

void compare_with_oracle(Family family, std::uint64_t first_seed, std::uint64_t count) {
  std::uint64_t conclusive = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    conclusive += agrees_with_oracle(family(generator)) ? 1 : 0;
  }
  CHECK(10 * conclusive >= 9 * count);
}

/// A change of a pair that changes its intersection graph by renaming alone.
struct Change {
  const char* name;
  std::function<Pair(const Pair&, Generator&)> apply;
  Renaming renaming;
};

Pair image(const Pair& pair, const random_pairs::AffineMap& map) { return {map(pair.x), map(pair.y)}; }

Pair permuted(const Pair& pair, Generator&) {
  return image(pair, {{Point{0, 1, 0}, Point{0, 0, 1}, Point{1, 0, 0}}, {0, 0, 0}});
}

Pair scaled_and_moved(const Pair& pair, Generator& generator) {
  const Rational scale(random_pairs::integer(generator, 1, 9), random_pairs::integer(generator, 10, 30));
  const auto shift = [&] { return Rational(random_pairs::integer(generator, -9, 9), 7); };
  return image(pair,
               {{Point{scale, 0, 0}, Point{0, scale, 0}, Point{0, 0, scale}}, {shift(), shift(), shift()}});
}

std::vector<Change> changes() {
  return {
      {"patches exchanged",
       [](const Pair& p, Generator&) {
         return Pair{p.y, p.x};
       },
       {{2, 3, 0, 1}, {}}},
      {"u and v exchanged",
       [](const Pair& p, Generator&) {
         return Pair{p.x.exchanged(), p.y};
       },
       {{1, 0, 2, 3}, {}}},
      {"r and s exchanged",
       [](const Pair& p, Generator&) {
         return Pair{p.x, p.y.exchanged()};
       },
       {{0, 1, 3, 2}, {}}},
      {"u and s reversed",
       [](const Pair& p, Generator&) {
         return Pair{p.x.reversed_first(), p.y.reversed_second()};
       },
       {{0, 1, 2, 3}, {true, false, false, true}}},
      {"v and r reversed",
       [](const Pair& p, Generator&) {
         return Pair{p.x.reversed_second(), p.y.reversed_first()};
       },
       {{0, 1, 2, 3}, {false, true, true, false}}},
      {"coordinates permuted", permuted, {}},
      {"scaled and translated", scaled_and_moved, {}},
      {"mapped affinely",
       [](const Pair& p, Generator& generator) { return image(p, random_pairs::affine_map(generator)); },
       {}},
  };
}

void check_changes(Family family, std::uint64_t count) {
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Generator generator(seed);
    const Pair pair = family(generator);
    const auto result = intersect_exactly(pair.x, pair.y);
    for (const Change& change : changes()) {
      INFO("seed " << seed << ", " << change.name);
      const Pair changed = change.apply(pair, generator);
      const auto other = intersect_exactly(changed.x, changed.y);
      CHECK(other.status == result.status);
      CHECK(difference(result.graph, other.graph, change.renaming) == "");
    }
  }
}

}  // namespace

TEST_CASE("intersect: agrees with the oracle on small rationals") {
  compare_with_oracle(random_pairs::small_rationals, 1, 60);
}

TEST_CASE("intersect: agrees with the oracle on more small rationals") {
  compare_with_oracle(random_pairs::small_rationals, 61, 60);
}

TEST_CASE("intersect: agrees with the oracle on doubles") {
  compare_with_oracle(random_pairs::doubles, 1, 40);
}

TEST_CASE("intersect: agrees with the oracle on scattered control points") {
  compare_with_oracle(random_pairs::scattered, 1, 40);
}

TEST_CASE("intersect: agrees with the oracle on small loops") {
  compare_with_oracle(random_pairs::loop, 1, 40);
}

TEST_CASE("intersect: renames only when a pair of small rationals is changed") {
  check_changes(random_pairs::small_rationals, 30);
}

TEST_CASE("intersect: renames only when a small loop is changed") { check_changes(random_pairs::loop, 10); }

}  // namespace exsect::intersect_property_test
