// Overlapping pieces of one surface in doubles, against the exact solution.
#include "filter/overlap.h"

#include "filter/filter.h"
#include "intersect_exactly.h"
#include "support/catch.h"
#include "support/families.h"
#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::overlap_test {
namespace {

using random_pairs::Generator;
using random_pairs::integer;
using random_pairs::Pair;

/// A bounded piece of the surface that overlaps the square, in parameters that may be exchanged or reversed.
BezierPatch piece_of(const BezierPatch& x, Generator& generator) {
  const auto ends = [&] {
    const Rational from(integer(generator, -3, 5), 8);
    const Rational to = from + Rational(integer(generator, 2, 8), 8);
    return integer(generator, 0, 1) == 0 ? std::array{from, to} : std::array{to, from};
  };
  const auto u = ends();
  const auto v = ends();
  const BezierPatch piece = x.restricted_to(u[0], u[1], v[0], v[1]);
  return integer(generator, 0, 1) == 0 ? piece : piece.exchanged();
}

bool has_overlap(const IntersectResult& result) { return result.graph.overlaps.size() == 1; }

/// True if doubles find an overlap; then the graph is sound and that of the exact solution.
bool agrees(const Pair& pair, const IntersectOptions& options = {}) {
  const auto filtered = intersect_filtered(pair.x, pair.y, options);
  if (!filtered || !has_overlap(*filtered)) return false;
  CHECK(unsound(pair.x, pair.y, *filtered) == "");
  const IntersectResult exact = intersect_exactly(pair.x, pair.y, options);
  if (exact.status == Status::complete) CHECK(difference(filtered->graph, exact.graph, {}) == "");
  return exact.status == Status::complete;
}

}  // namespace

TEST_CASE("filter overlap: pieces of one surface as the exact solution finds them") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const BezierPatch x =
        seed % 2 == 0 ? random_pairs::small_rationals(generator).x : random_pairs::doubles(generator).x;
    decided += agrees({x, piece_of(x, generator)}) ? 1 : 0;
  }
  CHECK(decided >= 16);
}

TEST_CASE("filter overlap: crumpled surfaces, which meet themselves") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const BezierPatch x = random_pairs::scattered(generator).x;
    decided += agrees({x, piece_of(x, generator)}) ? 1 : 0;
  }
  INFO(decided << " decided");
  CHECK(decided < 16);
}

TEST_CASE("filter overlap: a patch and itself, other tolerances") {
  Generator generator(2);
  const BezierPatch x = random_pairs::small_rationals(generator).x;
  for (const double tolerance : {1e-2, 1e-6, 1e-9}) {
    IntersectOptions options;
    options.tolerance = tolerance;
    CHECK(agrees({x, x}, options));
    CHECK(agrees({x, x.reversed_first().exchanged()}, options));
    CHECK(agrees({x, x.restricted_to(Rational(1, 3), 2, Rational(1, 5), Rational(4, 5))}, options));
  }
}

TEST_CASE("filter overlap: a copy that is none, or has no rectangle in common") {
  Generator generator(4);
  const BezierPatch x = random_pairs::small_rationals(generator).x;
  const BezierPatch piece = x.restricted_to(Rational(1, 4), Rational(5, 4), 0, 1);
  REQUIRE(agrees({x, piece}));
  const auto found = [&](const BezierPatch& y) {
    const auto result = intersect_filtered(x, y, {});
    return result && !result->graph.overlaps.empty();
  };
  ControlNet net = piece.net();
  net[1][1][2] += power_of_two(-70);  // less than doubles show
  CHECK_FALSE(found(BezierPatch(net)));
  CHECK_FALSE(found(x.restricted_to(1, 2, 0, 1)));
  CHECK_FALSE(found(x.restricted_to(Rational(3, 2), 2, 0, 1)));
}

TEST_CASE("filter overlap: surfaces that are not injective") {
  // (u², v² + u² v², (u + v)(1 + u v)): (u,-u) and (-u,u) are the same point.
  ControlNet c{};
  c[2][0] = {1, 0, 0};
  c[0][2] = {0, 1, 0};
  c[1][0] = {0, 0, 1};
  c[0][1] = {0, 0, 1};
  c[2][1] = {0, 0, 1};
  c[1][2] = {0, 0, 1};
  c[2][2] = {0, 1, 0};
  const BezierPatch surface = BezierPatch::from_power_basis(c);
  const BezierPatch x = surface.restricted_to(-1, 1, -1, 1);
  const auto result =
      intersect_filtered(x, surface.restricted_to(Rational(-1, 2), 1, -1, Rational(1, 2)), {});
  CHECK_FALSE(result);
  CHECK(agrees({surface.restricted_to(Rational(1, 2), 1, Rational(1, 2), 1),
                surface.restricted_to(Rational(3, 4), Rational(5, 4), Rational(1, 4), Rational(3, 4))}));
}

}  // namespace exsect::overlap_test
