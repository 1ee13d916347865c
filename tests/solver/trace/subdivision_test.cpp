#include "trace/subdivision.h"

#include <algorithm>

#include "support/catch.h"
#include "support/graph_patches.h"
#include "trace/search_regions.h"

namespace exsect::subdivision_test {
using exsect::testing::graph_patch;
using exsect::testing::plane_patch;

namespace {

bool is_outside(const BallPoint<DoubleBall>& point) {
  return std::any_of(point.begin(), point.end(), [](const DoubleBall& c) {
    return c.is_negative() || (c - DoubleBall(1)).is_positive();
  });
}

/// e - (u-1/2)^2 - (v-1/2)^2.
exsect::testing::HeightCoefficients cap(const Rational& e) {
  return {{{e - Rational(1, 2), 1, -1}, {1, 0, 0}, {-1, 0, 0}}};
}

struct Found {
  SearchOutcome outcome;
  std::vector<Trace<DoubleBall>> curves;
};

Found search(const BezierPatch& x, const BezierPatch& y, const std::array<double, 2>& direction) {
  const Point origin = {0, 0, 0};
  const PairSystem<DoubleBall> system(x, y, origin, 0);
  Found found;
  const SeedHandler<DoubleBall> known = [&](const BallPoint<DoubleBall>& seed) {
    if (is_outside(seed)) {
      return true;
    }
    for (const auto& curve : found.curves) {
      if (passes_through(curve, seed)) {
        return true;
      }
    }
    auto outcome = trace_loop(system, {}, seed, {});
    if (auto* trace = std::get_if<Trace<DoubleBall>>(&outcome)) {
      found.curves.push_back(std::move(*trace));
      return true;
    }
    return false;
  };
  found.outcome = search_closed_curves(system, {{0, 0, 0, 0}, {1, 1, 1, 1}}, direction, known, {}, {});
  return found;
}

bool contains_centre(const SearchRegion& box) {
  bool inside = true;
  for (std::size_t j = 0; j < 4; ++j) {
    inside = inside && box.lower[j] <= 0.5 && 0.5 <= box.upper[j];
  }
  return inside;
}

}  // namespace

TEST_CASE("the search finds a closed curve of any size, once", "[subdivision]") {
  for (const Rational& e :
       {Rational(1, 16), Rational(1, 1000), Rational(1, 1000000), Rational(1, 10000000000)}) {
    for (const std::array<double, 2> direction : {std::array<double, 2>{1, 0}, {0, 1}, {1, 0.375}}) {
      const Found found = search(graph_patch(cap(e)), plane_patch(), direction);
      CHECK(found.outcome.undecided.empty());
      REQUIRE(found.curves.size() == 1);
      CHECK(found.outcome.boxes < 5000);
    }
  }
}

TEST_CASE("the search proves that there is none", "[subdivision]") {
  for (const Rational& e : {Rational(-1, 16), Rational(-1, 1000000), Rational(-1, 1000000000000)}) {
    const Found found = search(graph_patch(cap(e)), plane_patch(), {1, 0.375});
    CHECK(found.outcome.undecided.empty());
    CHECK(found.curves.empty());
  }
}

TEST_CASE("the search does not split a thin slab across", "[subdivision]") {
  // Two graphs at the distance (u - 1/2)² + (v - 1/2)² + 10^-6: they do not meet.
  const Point origin = {0, 0, 0};
  const PairSystem<DoubleBall> system(graph_patch(cap(Rational(-1, 1000000))), plane_patch(), origin, 0);
  const SeedHandler<DoubleBall> none = is_outside;
  for (const double width : {0x1p-10, 0x1p-20, 0x1p-30}) {
    const SearchRegion slab = {{0.5, 0, 0, 0}, {0.5 + width, 1, 1, 1}};
    const SearchOutcome outcome = search_closed_curves(system, slab, {1, 0.375}, none, {}, {});
    CHECK(outcome.undecided.empty());
    CHECK(outcome.boxes < 1000);
  }
}

TEST_CASE("the search leaves a small box around a touch point and around a crossing", "[subdivision]") {
  const BezierPatch crossing =
      graph_patch({{{Rational(1, 4), Rational(-1, 2), 0}, {Rational(-1, 2), 1, 0}, {0, 0, 0}}});
  for (const BezierPatch& x : {graph_patch(cap(0)), crossing}) {
    const Found found = search(x, plane_patch(), {1, 0.375});
    const auto groups = merged(found.outcome.undecided);
    REQUIRE(groups.size() == 1);
    CHECK(contains_centre(groups[0]));
    CHECK(groups[0].upper[0] - groups[0].lower[0] < 1e-3);
  }
}

TEST_CASE("many regions are covered by few, quickly", "[subdivision]") {
  std::vector<SearchRegion> regions;  // of a surface of solutions
  constexpr int n = 200;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const double u = static_cast<double>(i) / n;
      const double v = static_cast<double>(k) / n;
      regions.push_back({{u, v, u, v}, {u + 0x1p-9, v + 0x1p-9, u + 0x1p-9, v + 0x1p-9}});
    }
  }
  const auto groups = merged(regions);
  CHECK(groups.size() <= 500);
  for (const SearchRegion& region : regions) {
    CHECK(std::any_of(groups.begin(), groups.end(), [&](const SearchRegion& group) {
      bool inside = true;
      for (std::size_t j = 0; j < 4; ++j) {
        inside = inside && group.lower[j] <= region.lower[j] && region.upper[j] <= group.upper[j];
      }
      return inside;
    }));
  }
}

TEST_CASE("touching regions are merged, distant ones are not", "[subdivision]") {
  const SearchRegion a = {{0, 0, 0, 0}, {1, 1, 1, 1}};
  const SearchRegion b = {{1, 0, 0, 0}, {2, 1, 1, 1}};
  const SearchRegion c = {{3, 0, 0, 0}, {4, 1, 1, 1}};
  CHECK(merged({}).empty());
  CHECK(merged({a, c}).size() == 2);
  CHECK(merged({a, c, b}).size() == 2);
  const SearchRegion bridge = {{2, 0, 0, 0}, {3, 1, 1, 1}};
  REQUIRE(merged({a, c, bridge, b}).size() == 1);
  CHECK(merged({a, c, bridge, b})[0].upper[0] == 4);
}

}  // namespace exsect::subdivision_test
