#include "star/symmetric_crossing.h"

#include "support/families.h"
#include "support/renaming_checks.h"

namespace exsect::symmetric_crossing_test {

namespace {

/// The image in the plane in which the first two coordinates agree, or in z = 0.
BezierPatch image(const BezierPatch& patch, bool exchange) {
  ControlNet net = patch.net();
  for (auto& row : net)
    for (Point& p : row) {
      if (exchange)
        std::swap(p[0], p[1]);
      else
        p[2] = -p[2];
    }
  return BezierPatch(net);
}

std::size_t crossings(const IntersectionGraph& graph) {
  return static_cast<std::size_t>(std::count_if(graph.nodes.begin(), graph.nodes.end(), [](const Node& node) {
    return std::count(node.kinds.begin(), node.kinds.end(), NodeKind::crossing) > 0;
  }));
}

}  // namespace

TEST_CASE("symmetries that exchange two patches", "[symmetry]") {
  const ExactCase c = families::mirror_images();
  const auto found = exchanging_symmetry(c.x, c.y);
  REQUIRE(found);
  CHECK(found->partner == std::array<std::size_t, 4>{2, 3, 0, 1});
  CHECK((!found->reversed[0] && !found->reversed[1]));
  const Rational third(1, 3);
  const Rational height = c.x(third, third)[2];
  CHECK(height != 0);
  CHECK((found->section(third, third) == height || found->section(third, third) == -2 * height));
  const auto turned = exchanging_symmetry(c.x, c.y.exchanged().reversed_first());
  REQUIRE(turned);  // r = 1 - v, s = u
  CHECK(turned->partner == std::array<std::size_t, 4>{3, 2, 1, 0});
  CHECK(turned->reversed == std::array<bool, 4>{false, true, true, false});
  ControlNet moved = c.y.net();
  moved[1][1][0] += Rational(1, 1000);
  CHECK(!exchanging_symmetry(c.x, BezierPatch(moved)));
  for (auto& row : moved)
    for (Point& p : row) p[2] = 1 - p[2];  // a translation: no involution
  CHECK(!exchanging_symmetry(c.y, BezierPatch(moved)));
}

TEST_CASE("symmetric crossings: random patches and their images", "[symmetry]") {
  constexpr unsigned seed = 20261122;
  INFO("seed " << seed);
  std::mt19937_64 generator(seed);
  std::size_t found = 0;
  for (int i = 0; i < 12; ++i) {
    ControlNet net;
    for (auto& row : net)
      for (Point& p : row)
        for (Rational& c : p) c = static_cast<int>(generator() % 7) - 3;
    const BezierPatch x(net);
    const BezierPatch y = image(x, i % 2 == 0);
    INFO("pair " << i);
    const IntersectResult result = complete_intersection(x, y);
    CHECK(compare_with_oracle(x, y, result.graph).difference == "");
    if (crossings(result.graph) > 0 && found == 0) check_renamings({x, y}, result.graph);
    found += crossings(result.graph);
  }
  CHECK(found >= 3);
}

}  // namespace exsect::symmetric_crossing_test
