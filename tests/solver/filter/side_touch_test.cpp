// Touch points on sides and in corners of patches that are not biquadratic: against the exact solution of
// biquadratic pairs, which are taken as bicubic ones and mapped projectively.
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <string>

#include "centre_cuts.h"
#include "filter/filter.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace exsect::side_touch_test {
namespace {

using height_pairs::Generator;
using height_pairs::Heights;
using random_nets::image;
using testing::Cut;
using testing::cuts;

/// The only thing in common.
void check_touch(const IntersectResult& result, std::size_t sides) {
  REQUIRE(result.status == Status::complete);
  REQUIRE(result.graph.nodes.size() == 1);
  CHECK(result.graph.isolated_points.size() == 1);
  CHECK(result.graph.arcs.empty());
  const Node& node = result.graph.nodes[0];
  CHECK(node.on.size() == sides);
  CHECK(std::count(node.kinds.begin(), node.kinds.end(), NodeKind::touch) == 1);
  CHECK(std::count(node.kinds.begin(), node.kinds.end(), NodeKind::boundary) == 1);
}
/// In doubles its parameters are exact.
void check_exact_touch(const IntersectResult& result, std::size_t sides) {
  check_touch(result, sides);
  for (const RationalInterval& w : result.graph.nodes[0].box) CHECK(w.lower == w.upper);
}

}  // namespace

TEST_CASE("filter side touch: as the exact solution finds it, and its projective image") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Generator generator(seed);
    const Heights pair = height_pairs::with_double_point(generator, 1, 2);
    const auto map = random_nets::projective_map(generator);
    for (const Cut& cut : cuts(pair)) {
      INFO("seed " << seed << ", " << cut.name);
      const IntersectResult expected = intersect(cut.x, cut.y);
      check_touch(expected, cut.sides);
      const IntersectResult elevated = intersect_in_doubles(cut.x, cut.y, {});
      CAPTURE(elevated.incomplete.empty() ? "" : elevated.incomplete[0].why);
      check_exact_touch(elevated, cut.sides);
      CHECK(difference(expected.graph, elevated.graph, {}) == "");
      const IntersectResult mapped = intersect(image(cut.x, map), image(cut.y, map));
      check_exact_touch(mapped, cut.sides);
      CHECK(difference(expected.graph, mapped.graph, {}) == "");
      const IntersectResult exchanged = intersect(image(cut.y, map), image(cut.x, map));
      CHECK(difference(expected.graph, exchanged.graph, {{2, 3, 0, 1}, {}}) == "");
    }
  }
}

TEST_CASE("filter side touch: cubic patches") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Generator generator(seed);
    const Heights pair = height_pairs::with_double_point(generator, 1, 3);
    for (const Cut& cut : cuts(pair)) {
      INFO("seed " << seed << ", " << cut.name);
      check_exact_touch(intersect(cut.x, cut.y), cut.sides);
      // Away from each other, and through each other: a curve that ends on the side, or nothing.
      const auto moved = [&](const Rational& by) {
        return image(cut.y, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, by}, {0, 0, 0, 1}}});
      };
      const IntersectResult apart = intersect(cut.x, moved(-power_of_two(-10)));
      CHECK(apart.status == Status::complete);
      CHECK(apart.graph.nodes.empty());
      const IntersectResult through = intersect(cut.x, moved(power_of_two(-10)));
      CHECK(through.status == Status::complete);
      CHECK(through.graph.count(ComponentShape::closed) == 0);
    }
  }
}

TEST_CASE("filter side touch: beside a curve") {
  using height_pairs::linear;
  const Rational half(1, 2);
  const auto a = linear(-half, 1, 0);
  const auto b = linear(-half, 0, 1);
  for (const Rational& away : {Rational(1, 4), Rational(1, 8)}) {
    const auto h = (a * a + b * b) * linear(-half - away, 1, Rational(1, 16));
    const Heights pair = height_pairs::heights(a * b, h, 3, Rational(3, 2), Rational(1, 8), {half, half});
    for (const Cut& cut : cuts(pair)) {
      INFO("away " << away << ", " << cut.name);
      const bool is_cut_off = std::string(cut.name) == "corner of y";  // r <= 1/2: the curve is in the rest
      const IntersectResult result = intersect(cut.x, cut.y);
      REQUIRE(result.status == Status::complete);
      CHECK(result.graph.isolated_points.size() == 1);
      CHECK((result.graph.count(ComponentShape::open) == 1) == !is_cut_off);
    }
  }
}

}  // namespace exsect::side_touch_test
