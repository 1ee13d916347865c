#include "filter/side_corners.h"

#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <cmath>

#include "filter/contact_finder.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/power_nets.h"
#include "support/random_nets.h"

namespace exsect::side_corners_test {
namespace {

using filter::Bicubic;
using filter::side_corners;
using testing::power_patch;
using testing::Terms;

const Terms kNone, kU = {{{1, 0}, 1}}, kV = {{{0, 1}, 1}};

Terms term(std::size_t i, std::size_t j, int c = 1) { return Terms{{{i, j}, c}}; }

/// (u, v, height) and the plane over twice the square: the side u = 0 of x is the one r = 0 of y if u divides
/// the height.
struct Scene {
  RationalPatch x, y;

  explicit Scene(const Terms& height, const Terms& r = term(1, 0, 2))
      : x(power_patch({kU, kV, height}, 3)), y(power_patch({r, kV, kNone}, 1)) {}
};

IntersectResult solve(const RationalPatch& x, const RationalPatch& y) {
  IntersectResult result = intersect(x, y);
  REQUIRE(result.status == Status::complete);
  return result;
}

/// How many arcs end in u = v = 0.
std::ptrdiff_t arcs_in_corner(const IntersectionGraph& graph) {
  const auto is_corner = [&](int id) {
    const Node& node = graph.nodes[static_cast<std::size_t>(id)];
    return node.on.size() == 4 && node.box[0].upper == 0 && node.box[1].upper == 0;
  };
  CHECK(std::ranges::count_if(graph.nodes, [&](const Node& node) { return is_corner(node.id); }) == 1);
  return std::ranges::count_if(graph.arcs, [&](const Arc& arc) { return is_corner(arc.from); }) +
         std::ranges::count_if(graph.arcs, [&](const Arc& arc) { return is_corner(arc.to); });
}

}  // namespace

TEST_CASE("side corners: both ends of a common side, and whether the patches touch there", "[filter]") {
  for (const bool touching : {false, true}) {
    const Scene scene(touching ? term(2, 1) + term(3, 0, -1) : term(1, 1) + term(2, 0, -1));
    const auto x = filter::elevated<Bicubic>(scene.x), y = filter::elevated<Bicubic>(scene.y);
    const auto pair = filter::make_pair_of<Bicubic>(x, y).value();
    const auto contacts = filter::find_contacts<Bicubic>(x, y, pair).value();
    const auto corners = side_corners<Bicubic>(x, y, pair, contacts);
    REQUIRE(corners.size() == 2);
    for (const filter::SideCorner& corner : corners) {
      CHECK(corner.corner.x == corner.corner.y);
      REQUIRE(corner.sides.size() == 1);
      CHECK(corner.sides[0].across == std::array<std::size_t, 2>{0, 2});
      CHECK(corner.sides[0].touching == touching);
    }
  }
}

TEST_CASE("side corners: two sides that meet in one corner", "[filter]") {
  const Scene scene(term(1, 1), kU);  // u v = 0 over the same square
  const auto x = filter::elevated<Bicubic>(scene.x), y = filter::elevated<Bicubic>(scene.y);
  const auto pair = filter::make_pair_of<Bicubic>(x, y).value();
  const auto corners = side_corners<Bicubic>(x, y, pair, filter::find_contacts<Bicubic>(x, y, pair).value());
  CHECK(corners.size() == 3);
  CHECK(std::ranges::count_if(corners, [](const auto& corner) { return corner.sides.size() == 2; }) == 1);
}

TEST_CASE("side corners: a curve that ends where a common side does", "[filter]") {
  // u (v - u), u^2 (v - u), and u (v - u)(v - 2 u) with two curves.
  const Terms two = term(1, 2) + term(2, 1, -3) + term(3, 0, 2);
  for (const auto& [height, arcs] :
       {std::pair{term(1, 1) + term(2, 0, -1), 2}, std::pair{term(2, 1) + term(3, 0, -1), 2},
        std::pair{two, 3}, std::pair{term(1, 1) + term(2, 0), 1}}) {
    INFO("arcs " << arcs);
    const Scene scene(height);
    const IntersectionGraph graph = solve(scene.x, scene.y).graph;
    CHECK(graph.arcs.size() == static_cast<std::size_t>(arcs));
    CHECK(arcs_in_corner(graph) == arcs);
    CHECK(graph.components.size() == 1);
    CHECK(std::ranges::count_if(graph.arcs,
                                [](const Arc& arc) { return arc.place == ArcPlace::patch_boundary; }) == 1);
    // Seen by other parameters, and in another place of space.
    const auto reversed = solve(scene.x.transposed(), scene.y.transposed()).graph;
    CHECK(reversed.arcs.size() == graph.arcs.size());
    random_pairs::Generator generator(61500);
    const auto map = random_nets::projective_map(generator);
    const auto moved = solve(random_nets::image(scene.x, map), random_nets::image(scene.y, map)).graph;
    CHECK(moved.arcs.size() == graph.arcs.size());
    CHECK(arcs_in_corner(moved) == arcs);
    const auto exchanged = solve(scene.y, scene.x).graph;
    CHECK(exchanged.arcs.size() == graph.arcs.size());
  }
}

}  // namespace exsect::side_corners_test
