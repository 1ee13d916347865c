// Sides that lie on the other patch, in doubles: found, proved, and the same graph as the exact solution.
#include "filter/side_path.h"

#include "filter/contact.h"
#include "filter/filter.h"
#include "intersect_exactly.h"
#include "support/catch.h"
#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/side_pairs.h"

namespace exsect::side_path_test {
namespace {

using random_pairs::Generator;
using random_pairs::Pair;

const Renaming kExchanged = {{2, 3, 0, 1}, {}};

struct Counts {
  int decided = 0;  // in doubles, of two orders each
  int compared = 0;
};

/// In both orders, with each other, and with the exact solution where that is complete in time.
void check(const Pair& pair, bool exactly, Counts& counts) {
  const auto filtered = intersect_filtered(pair.x, pair.y, {});
  const auto exchanged = intersect_filtered(pair.y, pair.x, {});
  counts.decided += (filtered ? 1 : 0) + (exchanged ? 1 : 0);
  if (filtered) CHECK(unsound(pair.x, pair.y, *filtered) == "");
  if (exchanged) CHECK(unsound(pair.y, pair.x, *exchanged) == "");
  if (filtered && exchanged) CHECK(difference(filtered->graph, exchanged->graph, kExchanged) == "");
  if (!filtered || !exactly) return;
  IntersectOptions options;
  options.max_seconds = 2;
  const IntersectResult exact = intersect_exactly(pair.x, pair.y, options);
  if (exact.status != Status::complete) return;
  ++counts.compared;
  CHECK(difference(filtered->graph, exact.graph, {}) == "");
}

Counts check_family(Pair (*family)(Generator&), std::uint64_t first, std::uint64_t count, bool exactly) {
  Counts counts;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    check(family(generator), exactly, counts);
  }
  return counts;
}

void check_families(std::uint64_t first, std::uint64_t count, int least_decided, bool exactly) {
  for (std::size_t k = 0; k < side_pairs::all.size(); ++k) {
    INFO("family " << k);
    const Counts counts = check_family(side_pairs::all[k], first, count, exactly);
    CHECK(counts.decided >= least_decided);
    if (exactly) CHECK(counts.compared > 0);
    UNSCOPED_INFO("decided " << counts.decided << ", compared " << counts.compared);
  }
}

BezierPatch square() {
  ControlNet net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) net[i][j] = {Rational(i) - 1, Rational(j) - 1, 0};
  return BezierPatch(net);
}

/// Over x = 0, |y| <= 1/3 in the plane of the square, with these heights one step away from it, and twice
/// that at the other end.
BezierPatch standing(const std::array<Rational, 3>& heights, const Rational& lift = 0) {
  ControlNet net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net[i][j] = {Rational(i, 4), Rational(j, 3) - Rational(1, 3), Rational(i) * heights[j] + lift};
  return BezierPatch(net);
}

}  // namespace

TEST_CASE("filter side path: a side next to a line has no path") {
  const BezierPatch x = square();
  const std::array<Rational, 3> heights = {1, Rational(1, 2), 1};
  const auto on_line = intersect_filtered(x, standing(heights), {});
  REQUIRE(on_line);
  REQUIRE(on_line->graph.arcs.size() == 1);
  CHECK(on_line->graph.arcs[0].place == ArcPlace::patch_boundary);
  for (const long bits : {-30, -52, -80, -200}) {
    INFO("2^" << bits);
    const auto above = intersect_filtered(x, standing(heights, power_of_two(bits)), {});
    CHECK((!above || above->graph.arcs.empty()));
    const auto below = intersect_filtered(x, standing(heights, -power_of_two(bits)), {});
    CHECK((!below || (below->graph.arcs.size() == 1 && below->graph.arcs[0].place == ArcPlace::interior)));
  }
}

TEST_CASE("filter side path: a sheet that leaves its line on both sides of a plane is not decided") {
  // Another curve crosses the line where the sheet is tangent to the plane.
  CHECK_FALSE(intersect_filtered(square(), standing({1, 0, -1}), {}));
  CHECK_FALSE(intersect_filtered(standing({1, 0, -1}), square(), {}));
}

TEST_CASE("filter side path: agrees with the exact solution, in both orders") {
  check_families(1, 4, 6, true);
}

TEST_CASE("filter side path: hundreds of pairs, in both orders", "[.slow]") {
  check_families(1000, 200, 360, false);
}

}  // namespace exsect::side_path_test
