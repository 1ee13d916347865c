// Triangles in one plane, as patches of which a side is one point: what they share has the area of the
// clipped polygon.
#include <exsect/algebra/nearest_double.h>
#include <exsect/solver/intersect.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::coplanar_triangles_test {
namespace {

using random_pairs::Generator;
using Place = std::pair<Rational, Rational>;
using Polygon = std::vector<Place>;

Rational cross(const Place& o, const Place& a, const Place& b) {
  return (a.first - o.first) * (b.second - o.second) - (a.second - o.second) * (b.first - o.first);
}

Rational twice_area(const Polygon& p) {
  Rational sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Place &a = p[i], &b = p[(i + 1) % p.size()];
    sum += a.first * b.second - a.second * b.first;
  }
  return sum;
}

/// What of the polygon is to the left of the line from a to b.
Polygon clipped(const Polygon& polygon, const Place& a, const Place& b) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Place &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational at_p = cross(a, b, p), at_q = cross(a, b, q);
    if (at_p >= 0) result.push_back(p);
    if (at_p * at_q >= 0) continue;
    const Rational t = at_p / (at_p - at_q);
    result.emplace_back(p.first + t * (q.first - p.first), p.second + t * (q.second - p.second));
  }
  return result;
}

Polygon common_part(const Polygon& x, const Polygon& y) {
  Polygon result = x;
  for (std::size_t i = 0; i < y.size() && !result.empty(); ++i)
    result = clipped(result, y[i], y[(i + 1) % y.size()]);
  return result;
}

Polygon random_triangle(Generator& generator) {
  const auto number = [&] { return Rational(random_pairs::integer(generator, -2, 2)); };
  while (true) {
    Polygon p = {{number(), number()}, {number(), number()}, {number(), number()}};
    if (twice_area(p) > 0) return p;
  }
}

/// The pole is p[pole]; in the plane z = 0, or turned, times 25.4 and far away.
RationalPatch patch_of(const Polygon& p, std::size_t pole, bool is_placed) {
  const auto point = [&](std::size_t i) -> Point {
    const auto& [a, b] = p[(pole + i) % p.size()];
    if (!is_placed) return {a, b, 0};
    const Rational mm(254, 10);
    return {mm * Rational(3, 5) * a + 100000000, mm * b, mm * Rational(4, 5) * a};
  };
  return RationalPatch({{point(0), point(0)}, {point(1), point(2)}});
}

double enclosed_area(const Overlap& overlap) {
  double sum = 0;
  for (const auto& chain : overlap.chains)
    for (const Arc& arc : chain)
      for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i) {
        const auto &a = arc.polyline[i].point, &b = arc.polyline[i + 1].point;
        sum += a[0] * b[1] - a[1] * b[0];
      }
  return std::fabs(sum);
}

}  // namespace

TEST_CASE("coplanar triangles: the area they share, whichever corners are poles") {
  int overlaps = 0, same = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Generator generator(seed);
    const Polygon p = random_triangle(generator), q = seed % 8 == 0 ? p : random_triangle(generator);
    const auto pole_of_y = static_cast<std::size_t>(seed % 3);
    INFO("seed " << seed);
    const Rational area = twice_area(common_part(p, q));
    const RationalPatch x = patch_of(p, 0, false), y = patch_of(q, pole_of_y, false);
    const IntersectResult result = intersect(x, y);
    REQUIRE(result.status == Status::complete);
    REQUIRE(result.graph.overlaps.size() == (area > 0 ? 1 : 0));
    if (area > 0) {
      CHECK(std::fabs(enclosed_area(result.graph.overlaps[0]) - to_double(area)) < 1e-6);
      ++overlaps;
      same += seed % 8 == 0;
    }
    CHECK(difference(result.graph, intersect(y, x).graph, {{2, 3, 0, 1}, {}}) == "");
    if (seed % 4 == 1)
      CHECK(difference(result.graph, intersect(patch_of(p, 0, true), patch_of(q, pole_of_y, true)).graph,
                       {}) == "");
  }
  CHECK(overlaps >= 15);
  CHECK(same >= 5);
}

TEST_CASE("coplanar triangles: with rectangles, and one that crosses") {
  const Polygon p = {{0, 0}, {1, 0}, {0, 1}};
  const auto rectangle = [](const Rational& from, const Rational& to) {
    return RationalPatch({{{from, from, 0}, {from, to, 0}}, {{to, from, 0}, {to, to, 0}}});
  };
  for (const auto& [from, to, area] : {std::tuple(Rational(0), Rational(1), Rational(1)),
                                       {Rational(-1), Rational(1), Rational(1)},
                                       {Rational(1, 4), Rational(1), Rational(1, 4)},
                                       {Rational(0), Rational(1, 2), Rational(1, 2)}}) {
    INFO(to_double(from) << " " << to_double(to));
    const IntersectResult result = intersect(patch_of(p, 0, false), rectangle(from, to));
    REQUIRE(result.status == Status::complete);
    REQUIRE(result.graph.overlaps.size() == 1);
    CHECK(std::fabs(enclosed_area(result.graph.overlaps[0]) - to_double(area)) < 1e-6);
  }
  const RationalPatch wall(
      {{{Rational(1, 4), Rational(1, 4), 0}, {Rational(1, 4), Rational(1, 4), 0}}, {{0, 0, 1}, {0, 0, -1}}});
  const IntersectResult crossing = intersect(patch_of(p, 0, false), wall);
  REQUIRE(crossing.status == Status::complete);
  CHECK(crossing.graph.overlaps.empty());
  CHECK(crossing.graph.arcs.size() == 1);
}

TEST_CASE("coplanar triangles: a common part of sides up to a Moebius map with a pole beside the part") {
  const RationalPatch x({{{0, 0, 0}, {-2, 2, 0}}, {{1, 0, 0}, {-1, 2, 0}}}, {{2, 10}, {1, 5}});
  const RationalPatch y({{{-3, 0, 0}, {-3, 1, 0}}, {{-3, 0, 0}, {1, 0, 0}}});
  for (const bool is_exchanged : {false, true}) {
    const IntersectResult result = is_exchanged ? intersect(y, x) : intersect(x, y);
    REQUIRE(result.status == Status::complete);
    REQUIRE(result.graph.overlaps.size() == 1);
    CHECK(std::fabs(enclosed_area(result.graph.overlaps[0]) - 1.0 / 3) < 1e-5);
  }
}

}  // namespace exsect::coplanar_triangles_test
