// Pieces of one round surface that are turned against each other: their overlaps point by point.
#include <exsect/solver/intersect_rational.h>

#include <algorithm>

#include "solver/special/revolved.h"
#include "support/catch.h"
#include "support/chain_checks.h"
#include "support/graph_isomorphism.h"

namespace exsect::tilted_pieces_test {
namespace {

using random_nets::Generator;

/// Of the unit sphere: latitudes and longitudes from 2 atan(from) to 2 atan(to), less than half a turn.
struct Piece {
  std::array<Rational, 2> latitudes, longitudes;

  RationalPatch patch() const {
    return revolved::patch(revolved::arc(latitudes[0], latitudes[1]),
                           revolved::arc(longitudes[0], longitudes[1]));
  }
  /// Of a point of the sphere: between two parallels, and to the right sides of two meridians.
  bool contains(const HomogeneousPoint& p) const {
    const auto above = [&](const Rational& t) { return (1 + t * t) * p[2] - 2 * t * p[3]; };
    const auto beyond = [&](const Rational& t) { return (1 - t * t) * p[1] - 2 * t * p[0]; };
    return above(latitudes[0]) >= 0 && above(latitudes[1]) <= 0 && beyond(longitudes[0]) >= 0 &&
           beyond(longitudes[1]) <= 0;
  }
};

const Rational kHalf(1, 2);
const Piece kOctant = {{0, 1}, {0, 1}}, kZone = {{-kHalf, kHalf}, {-kHalf, kHalf}},
            kSmall = {{Rational(-1, 8), Rational(1, 8)}, {Rational(-1, 8), Rational(1, 8)}},
            kToPole = {{-kHalf, 1}, {-kHalf, kHalf}};

using Quaternion = std::array<int, 4>;

/// By the even-odd rule for all chains together.
bool is_covered(const IntersectionGraph& graph, double u, double v) {
  bool odd = false;
  for (const Overlap& overlap : graph.overlaps)
    for (const std::vector<Arc>& chain : overlap.chains) odd = odd != inside(chain, u, v);
  return odd;
}

/// The number of cells of x, of 256, whose middle is on y; each is in the overlap if and only if it is so.
int covered_cells(const IntersectionGraph& graph, const RationalPatch& x, const Piece& y) {
  int count = 0;
  for (int i = 0; i < 16; ++i)
    for (int j = 0; j < 16; ++j) {
      const Rational u(2 * i + 1, 32), v(2 * j + 1, 32);
      const bool expected = y.contains(x.homogeneous_at(u, v));
      if (is_covered(graph, to_double(u), to_double(v)) != expected) FAIL("at u " << u << ", v " << v);
      count += expected ? 1 : 0;
    }
  return count;
}

/// Both orders, with overlaps as they are; cells of x and of y that they cover.
std::array<int, 2> overlapping(const Piece& x, const Piece& y, const Quaternion& turn) {
  const auto [a, b, c, d] = turn;
  const Point nowhere = {0, 0, 0};
  const RationalPatch first = x.patch(), second = revolved::rotated(y.patch(), turn, nowhere);
  const IntersectResult result = intersect(first, second), exchanged = intersect(second, first);
  REQUIRE(result.status == Status::complete);
  REQUIRE(exchanged.status == Status::complete);
  CHECK(difference(result.graph, exchanged.graph, {{2, 3, 0, 1}, {}}) == "");
  return {covered_cells(result.graph, revolved::rotated(first, {a, -b, -c, -d}, nowhere), y),
          covered_cells(exchanged.graph, second, x)};
}

}  // namespace

TEST_CASE("tilted pieces: octants and zones of one sphere overlap as their points do") {
  struct Pair {
    const char* name;
    Piece x, y;
    Quaternion turn;
  };
  for (const auto& [name, x, y, turn] :
       {Pair{"octants by 3/5", kOctant, kOctant, {2, 1, 0, 0}},
        Pair{"octants about no common axis", kOctant, kOctant, {7, 1, 2, 1}},
        Pair{"octants about their pole", kOctant, kOctant, {3, 0, 0, 1}},
        Pair{"zones", kZone, kZone, {7, 1, 1, 0}}, Pair{"zones in a corner", kZone, kZone, {7, 1, 2, 3}},
        Pair{"one inside", kZone, kSmall, {7, 1, 2, 1}}, Pair{"a pole inside", kToPole, kZone, {2, 0, 1, 0}},
        Pair{"a pole in the middle", kOctant, kZone, {1, 0, -1, 0}}}) {
    INFO(name);
    const auto [of_x, of_y] = overlapping(x, y, turn);
    CHECK(of_x > 0);
    CHECK(of_y > 0);
  }
}

TEST_CASE("tilted pieces: one inside has its own sides for the rim") {
  const IntersectionGraph graph =
      intersect(kZone.patch(), revolved::rotated(kSmall.patch(), {7, 1, 2, 1}, {0, 0, 0})).graph;
  REQUIRE(graph.overlaps.size() == 1);
  CHECK(graph.nodes.size() == 4);
  for (const Node& node : graph.nodes) CHECK(node.on.size() == 2);
}

TEST_CASE("tilted pieces: only a corner in common") {
  const Piece quarter = {{0, kHalf}, {0, kHalf}};
  // Half a turn about the corner's direction, but for a little, and its mirror image in the corner.
  const IntersectionGraph graph =
      intersect(quarter.patch(), revolved::rotated(quarter.patch(), {-1, 3, 0, 0}, {0, 0, 0})).graph;
  CHECK(graph.overlaps.empty());
  CHECK(graph.arcs.empty());
  CHECK(graph.isolated_points.size() == 1);
}

TEST_CASE("tilted pieces: each with its pole inside the other one") {
  for (const Quaternion& turn : {Quaternion{0, 1, 1, 3}, Quaternion{0, 3, 2, 10}, Quaternion{1, 7, 8, 30}}) {
    INFO(turn[0] << ' ' << turn[1] << ' ' << turn[2] << ' ' << turn[3]);
    const auto [of_x, of_y] = overlapping(kOctant, kOctant, turn);
    CHECK(of_x > 0);
    CHECK(of_y > 0);
  }
  // The corners of the overlap are the ends of both poles' sides, and where other sides cross.
  const RationalPatch x = kOctant.patch();
  const IntersectionGraph graph = intersect(x, revolved::rotated(x, {0, 1, 1, 3}, {0, 0, 0})).graph;
  REQUIRE(graph.overlaps.size() == 1);
  for (const Side& pole : {Side{Parameter::u, 1}, Side{Parameter::r, 1}})
    CHECK(std::ranges::count_if(
              graph.nodes, [&](const Node& node) { return std::ranges::count(node.on, pole) > 0; }) == 2);
}

TEST_CASE("tilted pieces: a pole in a corner or on a side of the other one") {
  // The first two are the same octant, with poles in two of its corners.
  for (const Quaternion& turn : {Quaternion{1, 1, 1, 1}, Quaternion{1, -1, -1, -1}, Quaternion{1, 3, 3, 1},
                                 Quaternion{1, 3, 1, 3}, Quaternion{3, -1, -1, -3}, Quaternion{3, 1, 3, 1}}) {
    INFO(turn[0] << ' ' << turn[1] << ' ' << turn[2] << ' ' << turn[3]);
    overlapping(kOctant, kOctant, turn);
  }
  CHECK(overlapping(kOctant, kOctant, {1, 1, 1, 1}) == std::array<int, 2>{256, 256});
}

TEST_CASE("tilted pieces: random zones overlap as their points do") {
  Generator generator(24);
  const auto number = [&] { return static_cast<int>(generator() % 7) - 3; };
  const auto range = [&] {
    const Rational from(number(), 8);
    return std::array<Rational, 2>{from, from + Rational(2 + static_cast<int>(generator() % 3), 8)};
  };
  for (int round = 0; round < 6; ++round) {
    const Piece x{range(), range()}, y{range(), range()};
    const Quaternion turn = {5 + number(), number(), number(), number()};
    INFO("round " << round);
    overlapping(x, y, turn);
  }
}

}  // namespace exsect::tilted_pieces_test
