// Touch points and crossings with irrational parameters: of heights over a quadratic map of the plane,
// against the exact plane curve; of spheres and tori of weighted quarter circles, against what is known of
// them.
#include <exsect/geometry/implicit_surface.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>

#include "round_patches.h"
#include "support/catch.h"
#include "support/height_pairs.h"
#include "support/random_nets.h"

namespace exsect::irrational_double_points_test {
namespace {

using height_pairs::linear;
using height_pairs::times;
using random_nets::image;
using random_nets::ProjectiveMap;
using random_pairs::Generator;
using random_pairs::integer;
using testing::Terms;
using testing::torus;

struct Pair {
  RationalPatch x;
  RationalPatch y;
};

int of_kind(const IntersectionGraph& graph, NodeKind kind) {
  return static_cast<int>(std::count_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
    return std::count(node.kinds.begin(), node.kinds.end(), kind) > 0;
  }));
}

struct Counts {
  int open, closed, branched, isolated, crossings, ends;
  bool operator==(const Counts&) const = default;
};
Counts counts(const IntersectionGraph& graph) {
  return {graph.count(ComponentShape::open),     graph.count(ComponentShape::closed),
          graph.count(ComponentShape::branched), static_cast<int>(graph.isolated_points.size()),
          of_kind(graph, NodeKind::crossing),    graph.boundary_points()};
}

/// x is the graph of f + h over the square, y that of f over its image under a quadratic map.
struct CurvedHeights {
  Pair pair;
  RationalPatch difference;  // the graph of h over the square
  std::array<Rational, 2> at;
  Rational bend, m, k;

  Rational first(const Rational& r, const Rational& s) const {
    return Rational(-1, 4) + Rational(3, 2) * (r + bend * r * r) / (1 + bend) + m * (s - Rational(1, 2));
  }
  Rational second(const Rational& r, const Rational& s) const {
    return Rational(-1, 4) + Rational(3, 2) * s + k * (r - Rational(1, 2));
  }
};
CurvedHeights curved_heights(Generator& generator, int sign, const Rational& moved = 0) {
  const auto sixteenths = [&](int largest) { return Rational(integer(generator, -largest, largest), 16); };
  const Rational a = Rational(1, 2) + sixteenths(3), b = Rational(1, 2) + sixteenths(3);
  const Rational slope(2 * integer(generator, -4, 3) + 1, 16);
  const Terms p = linear(-a - slope * b, 1, slope), q = linear(-b + slope * a, -slope, 1);
  Terms h = p * p + times(Rational(sign * integer(generator, 4, 15), 16), q * q) +
            times(sixteenths(4), p * p * p) + times(sixteenths(4), p * q * q);
  h[{0, 0}] += moved;
  CurvedHeights result{{testing::power_patch({linear(0, 1, 0), linear(0, 0, 1), h}, 3),
                        testing::power_patch({linear(0, 1, 0), linear(0, 0, 1), h}, 3)},
                       testing::power_patch({linear(0, 1, 0), linear(0, 0, 1), h}, 3),
                       {a, b},
                       Rational(integer(generator, 1, 6), 8),
                       Rational(integer(generator, 1, 4), 16),
                       Rational(-integer(generator, 1, 4), 16)};
  const Rational c0 = result.first(0, 0), cs = result.m,
                 c2 = Rational(3, 2) * result.bend / (1 + result.bend);
  const Terms first =
      Terms{{{0, 0}, c0}, {{1, 0}, Rational(3, 2) / (1 + result.bend)}, {{2, 0}, c2}, {{0, 1}, cs}};
  const Terms second = linear(result.second(0, 0), result.k, Rational(3, 2));
  const std::array<Rational, 5> f = {sixteenths(3), sixteenths(3), sixteenths(3), sixteenths(3),
                                     sixteenths(3)};
  const auto height = [&](const Terms& x, const Terms& y) {
    return times(f[0], x) + times(f[1], y) + times(f[2], x * y) + times(f[3], y * y) + linear(f[4], 0, 0);
  };
  const Terms x = linear(0, 1, 0), y = linear(0, 0, 1);
  result.pair = {testing::power_patch({x, y, height(x, y) + h}, 3),
                 testing::power_patch({first, second, height(first, second)}, 3)};
  return result;
}

bool holds(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

/// A node over the rational point, whose parameters r and s are irrational.
void check_place(const CurvedHeights& heights, const IntersectionGraph& graph, NodeKind kind) {
  for (const Node& node : graph.nodes) {
    if (node.kinds != std::vector<NodeKind>{kind}) continue;
    CHECK(node.box[0].lower == heights.at[0]);
    CHECK(node.box[1].upper == heights.at[1]);
    CHECK(node.box[2].lower < node.box[2].upper);
    CHECK(node.box[2].width() < power_of_two(-50));
    const auto [r, s] = std::array{node.box[2], node.box[3]};
    CHECK(holds({heights.first(r.lower, s.lower), heights.first(r.upper, s.upper)},
                {heights.at[0], heights.at[0]}));
    CHECK(holds({heights.second(r.upper, s.lower), heights.second(r.lower, s.upper)},
                {heights.at[1], heights.at[1]}));
    return;
  }
  FAIL("no node is of this kind");
}

Counts expected_counts(const RationalPatch& difference) {
  const IntersectResult result =
      intersect(ImplicitSurface::plane({0, 0, 0}, {0, 0, 1}), difference, IntersectOptions{});
  CHECK(result.status == Status::complete);
  return counts(result.graph);
}

/// A rational unit vector near the x axis: at no rational parameters of a sphere, but by chance.
Point direction(Generator& generator) {
  const Rational p(integer(generator, 1, 9), 40), q(integer(generator, 1, 9), 40);
  const Rational n = 1 + p * p + q * q;
  return {(2 - n) / n, 2 * p / n, 2 * q / n};
}

/// Turned about the x axis by an angle whose cosine is 4/5, or not, x reversed if `mirrored`, and moved.
ProjectiveMap placed(bool turned, bool mirrored, const Point& by) {
  const Rational c = turned ? Rational(4, 5) : Rational(1), s = turned ? Rational(3, 5) : Rational(0);
  return {{{mirrored ? -1 : 1, 0, 0, by[0]}, {0, c, -s, by[1]}, {0, s, c, by[2]}, {0, 0, 0, 1}}};
}

struct Round {
  Pair pair;
  Point normal;  // of x where they touch
  bool inside;   // y touches x from inside: a smaller sphere
};
/// A unit sphere, and one that touches it from outside or inside.
Round spheres(Generator& generator) {
  const Point d = direction(generator);
  const bool inside = integer(generator, 0, 1) == 1;
  const Rational radius = inside ? Rational(1, 2) + Rational(integer(generator, 0, 5), 16)
                                 : Rational(integer(generator, 2, 20), 8);
  const Rational to_centre = inside ? Rational(1 - radius) : Rational(1 + radius);
  return {
      {torus(0, 1), image(torus(0, radius), placed(integer(generator, 0, 1) == 1, !inside, to_centre * d))},
      d,
      inside};
}
/// A torus at a rational point, and a sphere on it that is turned.
Round torus_and_sphere(Generator& generator) {
  const auto angle = [&] {
    const Rational t(integer(generator, -2, 2), 10);
    return std::array{Rational((1 - t * t) / (1 + t * t)), Rational(2 * t / (1 + t * t))};
  };
  const auto a = angle(), b = angle();
  const Rational major(integer(generator, 3, 6), 4), minor(1, 2), radius(integer(generator, 2, 9), 8);
  const Point d = {a[0] * b[0], a[0] * b[1], a[1]};
  const Rational far = major + minor * a[0];
  const Point at = {far * b[0], far * b[1], minor * a[1]};
  return {{torus(major, minor), image(torus(0, radius), placed(true, true, at + radius * d))}, d, false};
}

ProjectiveMap moved(const Point& by) {
  return {{{1, 0, 0, by[0]}, {0, 1, 0, by[1]}, {0, 0, 1, by[2]}, {0, 0, 0, 1}}};
}

void check_touch(const IntersectResult& result) {
  CAPTURE(result.incomplete.empty() ? "" : result.incomplete[0].why);
  REQUIRE(result.status == Status::complete);
  CHECK(result.graph.isolated_points.size() == 1);
  CHECK(of_kind(result.graph, NodeKind::touch) == 1);
  CHECK(result.graph.arcs.empty());
}

}  // namespace

TEST_CASE("filter irrational double points: cubic heights over a quadratic map") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const int sign = seed % 2 == 0 ? 1 : -1;
    const CurvedHeights heights = curved_heights(generator, sign);
    const auto map = random_nets::projective_map(generator);
    for (const bool weighted : {false, true}) {
      const IntersectResult result = weighted
                                         ? intersect(image(heights.pair.x, map), image(heights.pair.y, map))
                                         : intersect(heights.pair.x, heights.pair.y);
      if (result.status != Status::complete) continue;
      ++decided;
      CHECK(counts(result.graph) == expected_counts(heights.difference));
      check_place(heights, result.graph, sign > 0 ? NodeKind::touch : NodeKind::crossing);
    }
  }
  CHECK(decided >= 22);
}

TEST_CASE("filter irrational double points: on a side and in a corner of the first patch") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
    for (const bool corner : {false, true}) {
      INFO("seed " << seed << (corner ? ", corner" : ", side"));
      Generator generator(seed);
      const CurvedHeights heights = curved_heights(generator, seed % 2 == 0 ? 1 : -1);
      const auto cut = [&](const RationalPatch& patch) {
        return patch.restricted_to(heights.at[0], 1, corner ? heights.at[1] : Rational(0), 1);
      };
      const IntersectResult result = intersect(cut(heights.pair.x), heights.pair.y);
      if (result.status != Status::complete) continue;
      ++decided;
      Counts expected = expected_counts(cut(heights.difference));
      Counts found = counts(result.graph);
      // A plane curve has no kind of its own where it crosses on a side.
      expected.crossings = found.crossings = 0;
      CHECK(found == expected);
      const auto node = std::find_if(result.graph.nodes.begin(), result.graph.nodes.end(), [](const Node& n) {
        return n.kinds.size() > 1 && n.box[2].lower < n.box[2].upper && n.box[0].upper == 0;
      });
      REQUIRE(node != result.graph.nodes.end());
      CHECK(node->on.size() == (corner ? 2 : 1));
      CHECK(node->box[2].width() < power_of_two(-50));
    }
  CHECK(decided >= 12);
}

TEST_CASE("filter irrational double points: spheres that touch") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Round round = spheres(generator);
    check_touch(intersect(round.pair.x, round.pair.y));
    if (seed > 3) continue;
    check_touch(intersect(round.pair.y, round.pair.x));
    const ProjectiveMap far = {{{Rational(127, 5), 0, 0, 100000000},
                                {0, Rational(127, 5), 0, -100000000},
                                {0, 0, Rational(127, 5), 7},
                                {0, 0, 0, 1}}};
    check_touch(intersect(image(round.pair.x, far), image(round.pair.y, far)));
  }
}

TEST_CASE("filter irrational double points: a sphere on a torus") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Round round = torus_and_sphere(generator);
    check_touch(intersect(round.pair.x, round.pair.y));
  }
}

TEST_CASE("filter irrational double points: near misses are none") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const int digits : {3, 6, 9, 12, 20, 100})
      for (const int sign : {-1, 1}) {
        INFO("seed " << seed << ", " << sign << " 1e-" << digits);
        Rational away = sign;
        for (int i = 0; i < digits; ++i) away /= 10;
        Generator generator(seed);
        const Round round = seed % 2 == 0 ? spheres(generator) : torus_and_sphere(generator);
        const IntersectResult result =
            intersect(round.pair.x, image(round.pair.y, moved(away * round.normal)));
        if (result.status == Status::complete) {
          ++decided;
          CHECK(result.graph.isolated_points.empty());
          CHECK(result.graph.count(ComponentShape::closed) == ((sign < 0) != round.inside ? 1 : 0));
        }
        Generator again(seed);
        const CurvedHeights heights = curved_heights(again, seed % 2 == 0 ? 1 : -1, away);
        const IntersectResult other = intersect(heights.pair.x, heights.pair.y);
        if (other.status != Status::complete) continue;
        ++decided;
        CHECK(counts(other.graph) == expected_counts(heights.difference));
      }
  CHECK(decided >= 48);
}

}  // namespace exsect::irrational_double_points_test
