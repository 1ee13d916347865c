// Crossings on sides and in corners of patches that are not biquadratic: against the exact solution of
// biquadratic pairs, which are taken as bicubic ones and mapped projectively, and against the plane curve in
// which the difference of two heights vanishes.
#include <exsect/geometry/implicit_surface.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>

#include "centre_cuts.h"
#include "filter/filter.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace exsect::side_crossing_test {
namespace {

using height_pairs::Generator;
using height_pairs::Heights;
using random_nets::image;
using testing::Cut;
using testing::cuts;

const Node* node_on(const IntersectionGraph& graph, std::size_t sides) {
  const auto is_there = [&](const Node& node) {
    return node.on.size() == sides &&
           (std::count(node.kinds.begin(), node.kinds.end(), NodeKind::crossing) +
            std::count(node.kinds.begin(), node.kinds.end(), NodeKind::touch)) == 1;
  };
  const auto found = std::find_if(graph.nodes.begin(), graph.nodes.end(), is_there);
  return found == graph.nodes.end() ? nullptr : &*found;
}
int degree(const IntersectionGraph& graph, int node) {
  int ends = 0;
  for (const Arc& arc : graph.arcs) ends += (arc.from == node ? 1 : 0) + (arc.to == node ? 1 : 0);
  return ends;
}

/// By the exact plane curve: the most arcs that end in a point on a side.
int expected_degree(const RationalPatch& difference) {
  const IntersectResult result =
      intersect(ImplicitSurface::plane({0, 0, 0}, {0, 0, 1}), difference, IntersectOptions{});
  CHECK(result.status == Status::complete);
  int most = 0;
  for (const Node& node : result.graph.nodes)
    if (!node.on.empty()) most = std::max(most, degree(result.graph, node.id));
  return most;
}

}  // namespace

TEST_CASE("filter side crossing: as the exact solution finds it, and its projective image") {
  int decided = 0;
  int all = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Generator generator(seed);
    const Heights pair = height_pairs::with_double_point(generator, -1, 2);
    const auto map = random_nets::projective_map(generator);
    for (const Cut& cut : cuts(pair)) {
      INFO("seed " << seed << ", " << cut.name);
      const IntersectResult expected = intersect(cut.x, cut.y);
      REQUIRE(expected.status == Status::complete);
      const auto agrees = [&](const IntersectResult& result, const Renaming& renaming) {
        CAPTURE(result.incomplete.empty() ? "" : result.incomplete[0].why);
        ++all;
        if (result.status != Status::complete) return;
        ++decided;
        CHECK(difference(expected.graph, result.graph, renaming) == "");
        CHECK(node_on(result.graph, cut.sides) != nullptr);
      };
      agrees(intersect_in_doubles(cut.x, cut.y, {}), {});
      agrees(intersect(image(cut.x, map), image(cut.y, map)), {});
      agrees(intersect(image(cut.y, map), image(cut.x, map)), {{2, 3, 0, 1}, {}});
    }
  }
  INFO(decided << " of " << all);
  CHECK(decided >= all * 9 / 10);
}

TEST_CASE("filter side crossing: cubic patches, and what lies next to them") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Generator generator(seed);
    const Heights pair = height_pairs::with_double_point(generator, -1, 3);
    const Rational a = pair.centre[0];
    const RationalPatch x = pair.x.restricted_to(a, 1, 0, 1);
    const RationalPatch difference = pair.difference.restricted_to(a, 1, 0, 1);
    INFO("seed " << seed);
    const IntersectResult result = intersect(x, pair.y);
    if (result.status == Status::complete) {
      ++decided;
      const Node* node = node_on(result.graph, 1);
      REQUIRE(node != nullptr);
      CHECK(degree(result.graph, node->id) == 2);
      CHECK(degree(result.graph, node->id) == expected_degree(difference));
    }
    for (const int bits : {-10, 10, -30, 30}) {
      const Rational by = (bits < 0 ? -1 : 1) * power_of_two(-std::abs(bits));
      const auto moved = [&](const RationalPatch& patch) {
        return image(patch, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, by}, {0, 0, 0, 1}}});
      };
      const IntersectResult apart = intersect(x, moved(pair.y));
      if (apart.status != Status::complete) continue;
      CHECK(node_on(apart.graph, 1) == nullptr);
      const IntersectResult expected =
          intersect(ImplicitSurface::plane({0, 0, by}, {0, 0, 1}), difference, IntersectOptions{});
      CHECK(apart.graph.count(ComponentShape::open) == expected.graph.count(ComponentShape::open));
      CHECK(apart.graph.boundary_points() == expected.graph.boundary_points());
    }
  }
  CHECK(decided >= 3);
}

TEST_CASE("filter side crossing: a branch comes back to the side next to it") {
  using height_pairs::linear;
  using height_pairs::times;
  const Rational half(1, 2);
  const testing::Terms u = linear(0, 1, 0);
  const testing::Terms w = linear(-half, 0, 1);
  for (const int bits : {2, 4, 6})
    for (const int bend : {1, 3}) {
      INFO("2^-" << bits << ", " << bend);
      const testing::Terms parabola =
          u + times(Rational(-bend), w * (w + linear(-power_of_two(-bits), 0, 0)));
      const testing::Terms h = parabola * (w + times(Rational(-1, 3), u));
      const Heights pair =
          height_pairs::heights(w * u, h, 3, Rational(3, 2), Rational(1, 8), {Rational(0), half});
      const IntersectResult expected =
          intersect(ImplicitSurface::plane({0, 0, 0}, {0, 0, 1}), pair.difference, IntersectOptions{});
      const IntersectResult result = intersect(pair.x, pair.y);
      CAPTURE(result.incomplete.empty() ? "" : result.incomplete[0].why);
      REQUIRE(result.status == Status::complete);
      CHECK(result.graph.boundary_points() == expected.graph.boundary_points());
      CHECK(result.graph.count(ComponentShape::open) == expected.graph.count(ComponentShape::open));
      const Node* node = node_on(result.graph, 1);
      REQUIRE(node != nullptr);
      CHECK(degree(result.graph, node->id) == expected_degree(pair.difference));
    }
}

}  // namespace exsect::side_crossing_test
