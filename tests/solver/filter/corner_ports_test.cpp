#include "filter/corner_ports.h"

#include <algorithm>
#include <cmath>

#include "filter/contact_finder.h"
#include "filter/filtered_intersection.h"
#include "support/catch.h"
#include "support/power_nets.h"

namespace exsect::corner_ports_test {
namespace {

using filter::Bicubic;
using testing::power_patch;
using testing::Terms;

const Terms kNone, kU = {{{1, 0}, 1}}, kV = {{{0, 1}, 1}};
const Terms kTwo = {{{0, 0}, 2}};

Terms term(std::size_t i, std::size_t j, int c = 1) { return Terms{{{i, j}, c}}; }
/// 1 - w, or w.
Terms counted(const Terms& w, bool from_upper) { return from_upper ? term(0, 0) + term(0, 0, -1) * w : w; }

/// With the zeros of a height over (u,v) in [0,1]^2 for x, and the plane over [0,2]^2 for y, parameters
/// counted from upper ends where that is said.
struct Scene {
  RationalPatch x, y;

  Scene(const std::array<int, 3>& square, const Terms& rest, const std::array<bool, 2>& from_upper)
      : x(patch(square, rest, from_upper)),
        y(power_patch({kTwo * counted(kU, from_upper[1]), kTwo * kV, kNone}, 1)) {}

  static RationalPatch patch(const std::array<int, 3>& square, const Terms& rest,
                             const std::array<bool, 2>& from_upper) {
    const Terms u = counted(kU, from_upper[0]), v = kV;
    Terms height =
        term(0, 0, square[0]) * u * u + term(0, 0, square[1]) * u * v + term(0, 0, square[2]) * v * v;
    for (const auto& [power, c] : rest) {
      Terms product = {{{0, 0}, c}};
      for (std::size_t k = 0; k < power.first; ++k) product = product * u;
      for (std::size_t k = 0; k < power.second; ++k) product = product * v;
      height = height + product;
    }
    return power_patch({u, v, height}, 3);
  }
};

struct Found {
  filter::PairOf<Bicubic> pair;
  std::optional<filter::CentreOf<Bicubic>> centre;
};
Found find(const Scene& scene) {
  const auto a = filter::elevated<Bicubic>(scene.x), b = filter::elevated<Bicubic>(scene.y);
  const auto pair = filter::make_pair_of<Bicubic>(a, b).value();
  const auto corners = filter::find_contacts<Bicubic>(a, b, pair).value().corners;
  REQUIRE(corners.size() == 1);
  const auto net = filter::corner_net<Bicubic>(a, corners[0].x, std::nullopt);
  const auto found = filter::corner_branches(net, filter::corner_net<Bicubic>(b, corners[0].y, std::nullopt));
  REQUIRE(found);
  return {pair, filter::branched_corner<Bicubic>(pair, corners[0], net, *found)};
}

IntersectResult solve(const Scene& scene) {
  const Run run(IntersectOptions{});
  auto filtered = filter::filtered_intersection<Bicubic>(filter::elevated<Bicubic>(scene.x),
                                                         filter::elevated<Bicubic>(scene.y), run, false);
  REQUIRE(filtered.result);
  return *std::move(filtered.result);
}

}  // namespace

TEST_CASE("corner ports: on a cusp, in every position", "[filter]") {
  for (const bool first : {false, true})
    for (const bool second : {false, true}) {
      const Scene scene({0, 0, 2}, term(3, 0, -1), {first, second});  // 2 v^2 = u^3
      const auto [pair, centre] = find(scene);
      REQUIRE(centre);
      const filter::Vec4 corner = {first ? 0.5 : -0.5, -0.5, second ? 0.5 : -0.5, -0.5};
      CHECK(centre->on == corner);
      REQUIRE(centre->ports.size() == 1);
      const auto& port = centre->ports[0];
      const double u = first ? 0.5 - port.ball.middle[0] : port.ball.middle[0] + 0.5;
      const double v = port.ball.middle[1] + 0.5;
      CHECK(u > 0);
      CHECK(std::fabs(2 * v * v - u * u * u) <= 5 * port.ball.radius);
      CHECK(port.side == centre->on[port.parameter]);
      // The arc to it has no longer way than both sides of its rectangle.
      const double scale = std::ldexp(1.0, -static_cast<int>(pair.frame.exponent));
      CHECK(port.chord >= scale * u);
      CHECK(port.chord < 0.1);
      const IntersectResult result = solve(scene);
      REQUIRE(result.status == Status::complete);
      REQUIRE(result.graph.arcs.size() == 1);
      CHECK(result.graph.isolated_points.empty());
      const auto is_corner = [&](int id) {
        const Node& node = result.graph.nodes[static_cast<std::size_t>(id)];
        return node.on.size() == 4 && std::ranges::count(node.kinds, NodeKind::corner) == 1;
      };
      const Arc& arc = result.graph.arcs[0];
      CHECK(is_corner(arc.from) != is_corner(arc.to));
      for (const PolylineVertex& vertex : arc.polyline) {
        const double at = first ? 1 - vertex.parameters[0] : vertex.parameters[0];
        CHECK(std::fabs(2 * vertex.parameters[1] * vertex.parameters[1] - at * at * at) < 1e-6);
      }
    }
}

TEST_CASE("corner ports: two arcs from one corner, and an arc that is beyond the other patch", "[filter]") {
  const Scene both({2, -5, 3}, kNone, {false, false});  // (3 v - 2 u)(v - u) has an end in a corner
  const auto found = find(both);
  REQUIRE(found.centre);
  CHECK(found.centre->ports.size() == 2);
  const IntersectResult result = solve(Scene({2, -7, 3}, kNone, {false, false}));  // (3 v - u)(v - 2 u)
  CHECK(result.status == Status::complete);
  CHECK(result.graph.arcs.size() == 2);
  const IntersectResult one = solve(Scene({-2, -5, 3}, kNone, {false, false}));  // (3 v + u)(v - 2 u)
  CHECK(one.status == Status::complete);
  CHECK(one.graph.arcs.size() == 1);
}

}  // namespace exsect::corner_ports_test
