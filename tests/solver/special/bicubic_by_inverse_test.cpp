// Bicubic patches with weights and pieces of quadrics, in special position: curves of degrees 6 and 6.
#include <exsect/solver/intersect_rational.h>

#include "solver/special/revolved.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"

namespace exsect::bicubic_by_inverse_test {
namespace {

using random_nets::Generator;

/// In the plane x = `height`, around the point (height, 0, 0), with the parameters of a bent bicubic net, so
/// that those of a point are irrational in general.
RationalPatch plane_bicubic(Generator& generator, const Rational& height) {
  std::uniform_int_distribution<int> bend(-8, 8), weight(128, 512);
  std::vector<std::vector<Point>> points;
  std::vector<std::vector<Rational>> weights;
  for (int i = 0; i < 4; ++i) {
    points.emplace_back();
    weights.emplace_back();
    for (int j = 0; j < 4; ++j) {
      const Rational y = Rational(2 * i - 3, 6) + Rational(bend(generator), 128),
                     z = Rational(2 * j - 3, 6) + Rational(bend(generator), 128);
      points.back().push_back({height, y, z});
      weights.back().push_back(Rational(weight(generator), 256));
    }
  }
  return RationalPatch(points, weights);
}

/// Of the unit sphere, around (1,0,0), its parallels and meridians turned about no axis of space.
RationalPatch turned_zone() {
  const Rational h(1, 2);
  const RationalPatch zone = revolved::patch(revolved::arc(-h, h), revolved::arc(-h, h));
  return revolved::rotated(zone, {20, 1, 2, 3}, {0, 0, 0});
}

}  // namespace

TEST_CASE("bicubic by inverse: a plane that touches a turned sphere, and near misses") {
  Generator generator(Catch::rngSeed());
  const RationalPatch sphere = turned_zone();
  for (int i = 0; i < 3; ++i) {
    const Generator state = generator;
    INFO("seed " << Catch::rngSeed() << ", pair " << i);
    const RationalPatch plane = plane_bicubic(generator, 1);
    const IntersectResult result = intersect(plane, sphere);
    REQUIRE(result.status == Status::complete);
    CHECK(result.graph.isolated_points.size() == 1);
    CHECK(result.graph.arcs.empty());
    CHECK(difference(result.graph, intersect(sphere, plane).graph, {{2, 3, 0, 1}, {}}) == "");
    for (const int digits : {3, 9, 20}) {
      const Rational e = 1 / Rational(pow(Integer(10), static_cast<unsigned>(digits)));
      Generator same = state, again = state;
      const IntersectResult apart = intersect(plane_bicubic(same, 1 + e), sphere);
      CHECK(apart.status == Status::complete);
      CHECK(apart.graph.nodes.empty());
      const IntersectResult circle = intersect(plane_bicubic(again, 1 - e), sphere);
      CHECK(circle.status == Status::complete);
      CHECK(circle.graph.count(ComponentShape::closed) == 1);
    }
  }
}

}  // namespace exsect::bicubic_by_inverse_test
