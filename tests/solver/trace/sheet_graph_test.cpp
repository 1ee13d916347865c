#include "trace/sheet_graph.h"

#include "support/ball_checks.h"
#include "support/catch.h"
#include "support/graph_patches.h"

namespace exsect::sheet_graph_test {
namespace {

const Rational half(1, 2);

PairSystem<DoubleBall> system_of(const BezierPatch& x, const BezierPatch& y) { return {x, y, {0, 0, 0}, 0}; }

SearchRegion around(const std::array<double, 4>& w, double reach) {
  SearchRegion region{};
  for (std::size_t j = 0; j < 4; ++j) {
    region.lower[j] = w[j] - reach;
    region.upper[j] = w[j] + reach;
  }
  return region;
}

}  // namespace

TEST_CASE("sheet graph: pieces of one surface, whose parameters are affine functions", "[trace]") {
  // y = x over [1/4, 3/4] x [1/4, 3/4]: r = 2 u - 1/2, s = 2 v - 1/2.
  random_pairs::Generator generator(20273);
  for (int round = 0; round < 10; ++round) {
    const BezierPatch x = random_pairs::small_rationals(generator).x;
    const Rational lower(1, 4), upper(3, 4);
    const BezierPatch y = x.restricted_to(lower, upper, lower, upper);
    const auto system = system_of(x, y);
    const double u = 0.375, v = 0.5;
    const auto sheet = graph_over(system, around({u, v, 2 * u - 0.5, 2 * v - 0.5}, 0x1p-6));
    REQUIRE(sheet);
    CHECK(sheet->contraction < 1);
    for (const double du : {-0x1p-6, 0.0, 0x1p-7}) {
      const Rational r = 2 * from_double(u + du) - half;
      const Rational s = 2 * from_double(v - du) - half;
      CHECK(sheet->range[0].lower <= r);
      CHECK(r <= sheet->range[0].upper);
      CHECK(sheet->range[1].lower <= s);
      CHECK(s <= sheet->range[1].upper);
      // C (x - y) vanishes there, as x - y does, and C y' is regular: the sheet holds the point.
    }
  }
}

TEST_CASE("sheet graph: also of surfaces that meet in a curve, along C alone", "[trace]") {
  // x = (u, v, u - v), y = (r, s, 0): C (x - y) = 0 is r = u, s = v up to the tilt of C, everywhere.
  const testing::Terms h = {{{1, 0}, 1}, {{0, 1}, -1}};
  const auto system = system_of(testing::graph(h), testing::plane_patch());
  const auto sheet = graph_over(system, around({0.5, 0.5, 0.5, 0.5}, 0x1p-5));
  REQUIRE(sheet);
  CHECK(sheet->range[0].lower <= half);
  CHECK(half <= sheet->range[0].upper);
}

TEST_CASE("sheet graph: none where y is singular", "[trace]") {
  // y = (r^2, s, 0) is singular on r = 0.
  ControlNet c{};
  c[2][0][0] = 1;
  c[0][1][1] = 1;
  const BezierPatch square = BezierPatch::from_power_basis(c);
  const auto singular = system_of(testing::plane_patch(), square);
  CHECK_FALSE(graph_over(singular, around({0, 0.5, 0, 0.5}, 0x1p-8)));
  for (const double r : {0.5, 0.9}) {  // looked for from either, the solution is r = 1/2
    const auto sheet = graph_over(singular, around({0.25, 0.5, r, 0.5}, 0x1p-8));
    REQUIRE(sheet);
    CHECK(sheet->range[0].lower <= half);
    CHECK(half <= sheet->range[0].upper);
  }
}

}  // namespace exsect::sheet_graph_test
