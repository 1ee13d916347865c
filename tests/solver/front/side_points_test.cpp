// Curves that end, or pass, where sides of both patches meet: elevated pairs in doubles against exact
// arithmetic, and all pairs of the teapot.
#include <exsect/geometry/rational_patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/intersect_rational.h>

#include <cmath>

#include "filter/filter.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"
#include "support/random_pairs.h"

namespace exsect::side_points_test {
namespace {

using random_pairs::Generator;

/// Two sheets on one side, or on both sides, of the plane y = 0, each with a side in it; if `smooth`, at a
/// right angle to it. The first is over a square, the second stands on it.
random_pairs::Pair sheets_at_plane(Generator& generator, bool smooth, bool opposite) {
  const auto jitter = [&] { return Rational(random_pairs::integer(generator, -16, 16), 128); };
  ControlNet x;
  ControlNet y;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational a(static_cast<long>(i), 2);
      const Rational b(static_cast<long>(j), 2);
      const Rational off = j == 0 ? Rational(0) : b + jitter();
      x[i][j] = {a + jitter(), off, jitter()};
      y[i][j] = {Rational(1, 2) + jitter(), opposite ? -off : off, a - Rational(1, 2) + jitter()};
      if (smooth && j == 1) {
        x[i][j] = {x[i][0][0], off, x[i][0][2]};
        y[i][j] = {y[i][0][0], opposite ? -off : off, y[i][0][2]};
      }
    }
  }
  return {BezierPatch(x), BezierPatch(y)};
}

int compare(const random_pairs::Pair& pair) {
  const IntersectResult exact = intersect(pair.x, pair.y);
  const IntersectResult elevated = intersect_in_doubles(pair.x, pair.y, {});
  if (exact.status != Status::complete || elevated.status != Status::complete) return 0;
  CHECK(difference(exact.graph, elevated.graph, {}) == "");
  return 1;
}

int on_two_sides(const IntersectionGraph& graph) {
  return static_cast<int>(std::count_if(graph.nodes.begin(), graph.nodes.end(),
                                        [](const Node& node) { return node.on.size() > 1; }));
}

}  // namespace

TEST_CASE("side points: sheets with sides in one plane, as exact arithmetic has them") {
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= 32; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    complete += compare(sheets_at_plane(generator, seed % 2 == 0, seed % 4 < 2));
  }
  CHECK(complete >= 28);
}

TEST_CASE("side points: a curve through a common corner") {
  int complete = 0;
  int entering = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    random_pairs::Pair pair = random_pairs::small_rationals(generator);
    const auto& target = pair.x.net()[0][2];
    ControlNet net = pair.y.net();
    const Point from = net[2][0];
    for (auto& row : net)
      for (Point& p : row)
        for (std::size_t c = 0; c < 3; ++c) p[c] += target[c] - from[c];
    pair.y = BezierPatch(net);
    const int same = compare(pair);
    complete += same;
    if (same == 0) continue;
    const IntersectionGraph graph = intersect_in_doubles(pair.x, pair.y, {}).graph;
    CHECK(on_two_sides(graph) >= 1);
    entering += graph.arcs.empty() ? 0 : 1;
  }
  CHECK(complete == 24);
  CHECK(entering >= 3);
}

TEST_CASE("side points: common corners of small integers, as exact arithmetic has them") {
  int complete = 0;
  int entering = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const auto net = [&] {
      ControlNet points;
      for (auto& row : points)
        for (Point& p : row)
          for (Rational& c : p) c = random_pairs::integer(generator, -2, 2);
      return points;
    };
    const ControlNet x = net();
    ControlNet y = net();
    y[2][2] = x[0][2];
    if (seed % 3 == 0) y[0][0] = x[0][2];  // a patch that closes up there
    const random_pairs::Pair pair = {BezierPatch(x), BezierPatch(y)};
    const int same = compare(pair);
    complete += same;
    if (same == 0) continue;
    const auto ends = [](const Arc& arc, const Node& node) {
      return arc.from == node.id || arc.to == node.id;
    };
    const IntersectionGraph graph = intersect_in_doubles(pair.x, pair.y, {}).graph;
    for (const Node& node : graph.nodes) {
      if (node.on.size() < 4) continue;
      entering += static_cast<int>(std::count_if(graph.arcs.begin(), graph.arcs.end(),
                                                 [&](const Arc& arc) { return ends(arc, node); }));
    }
  }
  INFO(complete << " complete, " << entering << " arcs end in a common corner");
  CHECK(complete >= 57);
  CHECK(entering >= 6);
}

TEST_CASE("side points: sides of cubic patches that meet half-way along both") {
  int ends = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    random_nets::Nets nets = random_nets::scattered(generator, {3, 3, 3, 3});
    const Point target = nets.first()(1, Rational(1, 2));
    const Point from = nets.second()(Rational(1, 2), 1);
    for (auto& row : nets.y)
      for (Point& p : row)
        for (std::size_t c = 0; c < 3; ++c) p[c] += target[c] - from[c];
    const IntersectResult result = intersect(nets.first(), nets.second());
    REQUIRE(result.status == Status::complete);
    const auto is_there = [](const Node& node) {
      return node.on == std::vector<Side>{{Parameter::u, 1}, {Parameter::s, 1}} &&
             node.box[1].lower <= Rational(1, 2) && node.box[1].upper >= Rational(1, 2);
    };
    const auto& nodes = result.graph.nodes;
    const auto node = std::find_if(nodes.begin(), nodes.end(), is_there);
    REQUIRE(node != nodes.end());
    const auto& arcs = result.graph.arcs;
    ends += static_cast<int>(std::count_if(arcs.begin(), arcs.end(), [&](const Arc& arc) {
      return arc.from == node->id || arc.to == node->id;
    }));
  }
  CHECK(ends >= 6);
  CHECK(ends <= 18);
}

TEST_CASE("side points: next to a point on two sides, but not on them") {
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_pairs::Pair pair = sheets_at_plane(generator, true, seed % 2 == 0);
    ControlNet out = pair.y.net();
    ControlNet tilted = pair.y.net();
    for (auto& row : out)
      for (Point& p : row) p[1] += power_of_two(-70);                     // out of the plane
    for (auto& row : tilted) row[1][2] += row[1][1] * power_of_two(-70);  // and at no right angle
    for (const ControlNet& net : {out, tilted}) {
      const IntersectResult result = intersect_in_doubles(pair.x, BezierPatch(net), {});
      if (result.status != Status::complete) continue;
      CHECK(difference(intersect(pair.x, BezierPatch(net)).graph, result.graph, {}) == "");
    }
  }
}

TEST_CASE("side points: weights and degrees change nothing") {
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_pairs::Pair pair = sheets_at_plane(generator, seed % 2 == 0, seed % 4 < 2);
    // (x, y, z) -> (x, y, z) / (1 + x/4 + z/8) keeps the plane y = 0.
    const auto image = [](const BezierPatch& patch) {
      std::vector<std::vector<HomogeneousPoint>> net;
      for (const auto& row : patch.net()) {
        net.emplace_back();
        for (const Point& p : row) net.back().push_back({p[0], p[1], p[2], 1 + p[0] / 4 + p[2] / 8});
      }
      return RationalPatch::from_homogeneous(net);
    };
    const IntersectResult expected = intersect_in_doubles(pair.x, pair.y, {});
    for (const int degree : {2, 3}) {
      const IntersectResult weighted = intersect(image(pair.x).elevated(degree, degree), image(pair.y));
      if (expected.status != Status::complete || weighted.status != Status::complete) continue;
      ++complete;
      CHECK(difference(expected.graph, weighted.graph, {}) == "");
    }
  }
  CHECK(complete >= 18);
}

TEST_CASE("side points: all pairs of the teapot are complete, and its curves close up") {
  const RationalPatchFile file = read_rational_patches(EXSECT_EXAMPLES "/teapot.bpt");
  REQUIRE(file.patches.size() == 32);
  int sides = 0;
  std::vector<std::array<double, 3>> ends;  // of arcs inside, once for each node where one ends
  for (std::size_t i = 0; i < 32; ++i) {
    for (std::size_t j = i + 1; j < 32; ++j) {
      INFO("patches " << i + 1 << " and " << j + 1);
      const IntersectResult result = intersect(file.patches[i].patch, file.patches[j].patch);
      REQUIRE(result.status == Status::complete);
      std::vector<int> degree(result.graph.nodes.size(), 0);
      for (const Arc& arc : result.graph.arcs) {
        if (arc.place == ArcPlace::patch_boundary) {
          ++sides;
          continue;
        }
        ++degree[static_cast<std::size_t>(arc.from)];
        ++degree[static_cast<std::size_t>(arc.to)];
      }
      for (const Node& node : result.graph.nodes)
        if (degree[static_cast<std::size_t>(node.id)] == 1) ends.push_back(node.point);
    }
  }
  // 32 patches with 128 sides: 8 are poles; 4 at the rim of the lid, 4 at that of the body and 8 at the ends
  // of handle and spout have no neighbour.
  INFO("sides " << sides << ", ends " << ends.size());
  CHECK(sides == 52);
  CHECK(ends.size() == 16);
  // From each end the curve goes on in another pair.
  for (const auto& end : ends) {
    const auto is_near = [&](const std::array<double, 3>& other) {
      return std::abs(end[0] - other[0]) + std::abs(end[1] - other[1]) + std::abs(end[2] - other[2]) < 1e-6;
    };
    CHECK(std::count_if(ends.begin(), ends.end(), is_near) % 2 == 0);
  }
}

}  // namespace exsect::side_points_test
