// Patches that close against themselves in doubles: bands, also turned by half a turn, spheres and cones.
#include "self_in_doubles.h"

namespace exsect::closed_in_doubles_test {
namespace {

using namespace self_in_doubles;

/// A plane loop from (0,0) to (0,0) moved along a curve, with an edge where it closes: the side u = 1 is the
/// side u = 0, or this one in the other direction. Inner control points are moved at random.
RationalPatch closed_band(Generator& generator, int degree, bool weighted, bool twisted) {
  constexpr std::array<std::array<int, 2>, 4> loop = {{{0, 0}, {6, 0}, {0, 6}, {0, 0}}};
  const auto random = [&] { return Rational(random_pairs::integer(generator, -4, 4), 8); };
  random_nets::Net net(4);
  random_nets::Weights weights(4);
  for (std::size_t i = 0; i < 3; ++i)
    for (int j = 0; j <= degree; ++j) {
      const Rational a = loop[i][0] + random(), b = loop[i][1] + random();
      net[i].push_back({a, b, 4 * j - 2 * degree + random()});
      weights[i].push_back(weighted ? 1 + random() / 2 : Rational(1));
    }
  net[3] = net[0];
  weights[3] = weights[0];
  if (twisted) {
    std::ranges::reverse(net[3]);
    std::ranges::reverse(weights[3]);
  }
  return RationalPatch(net, weights);
}

/// One arc on sides, all along u1 = 0 and u2 = 1, or the other way round.
void check_seam(const IntersectionGraph& graph, bool twisted) {
  const auto on_sides = [](const Arc& arc) { return arc.place == ArcPlace::patch_boundary; };
  REQUIRE(std::ranges::count_if(graph.arcs, on_sides) == 1);
  CHECK((twisted || graph.arcs.size() == 1));
  CHECK(graph.isolated_points.empty());
  const Arc& arc = *std::ranges::find_if(graph.arcs, on_sides);
  for (const int end : {arc.from, arc.to})
    CHECK(graph.nodes.at(static_cast<std::size_t>(end)).on.size() == 4);
  for (const PolylineVertex& vertex : arc.polyline) {
    const auto& at = vertex.parameters;
    CHECK(at[0] + at[2] == 1);
    CHECK(at[0] * at[2] == 0);
    CHECK(std::fabs((twisted ? 1 - at[1] : at[1]) - at[3]) < 1e-9);
  }
}

}  // namespace

TEST_CASE("self in doubles: closed bands meet themselves along the sides where they close") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const bool twisted : {false, true})
      for (const bool weighted : {false, true}) {
        Generator generator(seed);
        const int degree = twisted ? 1 : 1 + static_cast<int>(seed % 3);
        INFO("seed " << seed << ", twisted " << twisted << ", weighted " << weighted);
        const RationalPatch x = closed_band(generator, degree, weighted, twisted);
        const IntersectResult result = self_intersect(x);
        check_complete(result);
        check_seam(result.graph, twisted);
        check_same(self_intersect(x.transposed()), result.graph, {{1, 0, 3, 2}, {}});
      }
}

TEST_CASE("self in doubles: a band that closes after a turn of half its length") {
  // x = (loop(u), v + u/2): x(0,v + 1/2) = x(1,v).
  constexpr std::array<std::array<int, 2>, 4> loop = {{{0, 0}, {3, 0}, {0, 3}, {0, 0}}};
  random_nets::Net net(4);
  for (std::size_t i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) net[i].push_back({loop[i][0], loop[i][1], 6 * j + static_cast<int>(i)});
  const IntersectResult result = self_intersect(RationalPatch(net));
  check_complete(result);
  REQUIRE(result.graph.arcs.size() == 1);
  for (const PolylineVertex& vertex : result.graph.arcs[0].polyline) {
    const auto& at = vertex.parameters;
    CHECK(std::fabs(std::fabs(at[1] - at[3]) - 0.5) < 1e-12);
    CHECK(at[0] + at[2] == 1);
  }
}

TEST_CASE("self in doubles: parts of a sphere and of cones, up to their poles") {
  // From pole to pole, a quarter around; an eighth of it; a cone over a quarter of a circle.
  random_nets::Net lune(4), octant(3), cone(2);
  random_nets::Weights lune_weights(4), octant_weights(3), cone_weights(2);
  constexpr std::array<std::array<int, 2>, 3> around = {{{1, 0}, {1, 1}, {0, 1}}};
  constexpr std::array<int, 3> around_weights = {1, 1, 2};
  const auto append = [&](random_nets::Net& net, random_nets::Weights& weights, std::size_t i, int radius,
                          int height, const Rational& weight) {
    for (std::size_t j = 0; j < 3; ++j) {
      net[i].push_back({radius * around[j][0], radius * around[j][1], height});
      weights[i].push_back(weight * around_weights[j]);
    }
  };
  for (std::size_t i = 0; i < 4; ++i)
    append(lune, lune_weights, i, i % 3 == 0 ? 0 : 2, i < 2 ? -1 : 1, i % 3 == 0 ? 3 : 1);
  append(octant, octant_weights, 0, 1, 0, 1);
  append(octant, octant_weights, 1, 1, 1, 1);
  append(octant, octant_weights, 2, 0, 1, 2);
  append(cone, cone_weights, 0, 0, 0, 1);
  append(cone, cone_weights, 1, 1, 1, 1);
  Generator generator(5);
  for (const auto& [x, poles] : {std::pair(RationalPatch(lune, lune_weights), 2U),
                                 std::pair(RationalPatch(octant, octant_weights), 1U),
                                 std::pair(RationalPatch(cone, cone_weights), 1U)})
    for (const RationalPatch& image : {x, x.transposed(), x.restricted_to(1, 0, 1, 0),
                                       random_nets::image(x, random_nets::projective_map(generator))}) {
      const IntersectResult result = self_intersect(image);
      check_complete(result);
      CHECK(result.graph.arcs.empty());
      CHECK(result.graph.nodes.size() == poles);
      CHECK(result.graph.isolated_points.size() == poles);
    }
}

TEST_CASE("self in doubles: a cone over a closed loop meets itself along a line from its apex") {
  const Point apex = {0, 0, 0};
  const RationalPatch x({{apex, apex, apex, apex}, {{-1, -1, 2}, {2, -1, 2}, {-1, 2, 2}, {-1, -1, 2}}});
  const IntersectResult result = self_intersect(x);
  check_complete(result);
  REQUIRE(result.graph.arcs.size() == 1);
  CHECK(result.graph.isolated_points.empty());
  const Arc& arc = result.graph.arcs[0];
  for (const PolylineVertex& vertex : arc.polyline) {
    CHECK(vertex.parameters[1] + vertex.parameters[3] == 1);
    CHECK(std::fabs(vertex.parameters[0] - vertex.parameters[2]) < 1e-12);
  }
  check_same(self_intersect(x.transposed()), result.graph, {{1, 0, 3, 2}, {}});
}

}  // namespace exsect::closed_in_doubles_test
