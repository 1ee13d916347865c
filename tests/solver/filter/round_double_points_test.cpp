// Spheres, cylinders and tori of weighted quarter circles (1, 1, 2) that touch, or cross, in a rational
// point: against what is known of the two surfaces there.
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <cmath>

#include "round_patches.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace exsect::round_double_points_test {
namespace {

using random_nets::image;
using random_nets::ProjectiveMap;
using testing::arc;
using testing::ArcVector;
using testing::sphere;
using testing::torus;

/// About the z axis.
RationalPatch cylinder(const Rational& radius) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const ArcVector& a : arc())
    net.push_back({{radius * a[0], radius * a[1], -a[2], a[2]}, {radius * a[0], radius * a[1], a[2], a[2]}});
  return RationalPatch::from_homogeneous(net);
}
/// Equal cylinders are images of each other: arcs would end on sides of both.
RationalPatch middle(const RationalPatch& patch) {
  return patch.restricted_to(Rational(1, 8), Rational(7, 8), Rational(1, 16), Rational(15, 16));
}
RationalPatch plane(const Rational& x) {
  const Rational half(1, 2);
  return RationalPatch({{{x, -1, -half}, {x, -half, 1}}, {{x, half, -1}, {x, 1, half}}});
}

/// Along the x axis, after a turn about it whose cosine is 4/5, and a change of sign of x.
RationalPatch placed(const RationalPatch& patch, const Rational& along, bool mirrored = false) {
  const Rational c(4, 5);
  const Rational s(3, 5);
  const ProjectiveMap map = {{{mirrored ? -1 : 1, 0, 0, along}, {0, c, -s, 0}, {0, s, c, 0}, {0, 0, 0, 1}}};
  return image(patch, map);
}

struct Scene {
  const char* name;
  RationalPatch x;
  RationalPatch y;
  bool crossing;
  int inwards;  // the sign of the displacement of y by which touching patches begin to cross
};
std::vector<Scene> scenes() {
  return {
      {"sphere on a plane", sphere(1), plane(1), false, -1},
      {"sphere on a sphere", sphere(1), placed(sphere(1), 2, true), false, -1},
      {"sphere in a sphere", sphere(1), placed(sphere(Rational(3, 2)), Rational(-1, 2)), false, -1},
      {"sphere on a cylinder", sphere(1), placed(cylinder(Rational(2, 3)), Rational(5, 3), true), false, -1},
      {"cylinders of different directions", cylinder(1), placed(cylinder(1), 2, true), false, -1},
      {"equator of a torus and a plane", torus(Rational(2, 3), Rational(1, 3)), plane(1), false, -1},
      {"Viviani's curve", cylinder(1), placed(sphere(2), -1), true, 0},
      {"equal cylinders", cylinder(1), placed(middle(cylinder(1)), 0), true, 0},
      {"inner equator of a torus and a plane", torus(Rational(-2), Rational(1)), plane(-1), true, 0},
      {"inner equator of a torus and a sphere", torus(Rational(-2), Rational(1)), placed(sphere(2), -3), true,
       0},
  };
}

int of_kind(const IntersectionGraph& graph, NodeKind kind) {
  const Rational half(1, 2);
  return static_cast<int>(std::count_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
    return node.kinds == std::vector<NodeKind>{kind} &&
           std::all_of(node.box.begin(), node.box.end(),
                       [&](const RationalInterval& w) { return w.lower == half && w.upper == half; });
  }));
}

}  // namespace

TEST_CASE("filter round double points: weighted quarters touch or cross in their middles") {
  for (const Scene& scene : scenes()) {
    INFO(scene.name);
    const IntersectResult result = intersect(scene.x, scene.y);
    CAPTURE(result.incomplete.empty() ? "" : result.incomplete[0].why);
    REQUIRE(result.status == Status::complete);
    CHECK(of_kind(result.graph, NodeKind::touch) == (scene.crossing ? 0 : 1));
    CHECK(of_kind(result.graph, NodeKind::crossing) == (scene.crossing ? 1 : 0));
    CHECK(result.graph.isolated_points.size() == (scene.crossing ? 0 : 1));
    CHECK(result.graph.count(ComponentShape::branched) == (scene.crossing ? 1 : 0));
    CHECK(result.graph.components.size() == (scene.crossing ? 1 : 0));
    const IntersectResult exchanged = intersect(scene.y, scene.x);
    CHECK(exchanged.status == Status::complete);
    CHECK(difference(result.graph, exchanged.graph, {{2, 3, 0, 1}, {}}) == "");
  }
}

TEST_CASE("filter round double points: moved, one closed curve or none, two open curves") {
  for (const Scene& scene : scenes()) {
    for (const int bits : {10, 20}) {
      for (const int sign : {-1, 1}) {
        INFO(scene.name << ", " << sign << " 2^-" << bits);
        const Rational away = sign * power_of_two(-bits);
        const ProjectiveMap map = {{{1, 0, 0, away}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
        const IntersectResult result = intersect(scene.x, image(scene.y, map));
        CAPTURE(result.incomplete.empty() ? "" : result.incomplete[0].why);
        CHECK(result.status == Status::complete);
        CHECK(result.graph.isolated_points.empty());
        CHECK(result.graph.count(ComponentShape::branched) == 0);
        if (scene.crossing)
          CHECK(result.graph.count(ComponentShape::open) == 2);
        else
          CHECK(result.graph.count(ComponentShape::closed) == (sign == scene.inwards ? 1 : 0));
      }
    }
  }
}

}  // namespace exsect::round_double_points_test
