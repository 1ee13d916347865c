#include <exsect/geometry/surface_pull_back.h>
#include <exsect/solver/surface_curve.h>

#include <algorithm>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::surface_curve_test {
namespace {

/// Nodes, arcs, components, isolated points, singular points.
using Shape = std::array<int, 5>;

Shape shape(const CurveGraph& graph) {
  const auto singular = std::count_if(graph.nodes.begin(), graph.nodes.end(),
                                      [](const CurveNode& node) { return node.is_singular; });
  return {static_cast<int>(graph.nodes.size()), static_cast<int>(graph.arcs.size()), graph.components(),
          graph.isolated_points(), static_cast<int>(singular)};
}
Shape shape(const ImplicitSurface& surface, const RationalPatch& x) {
  return shape(surface_curve(surface, x).graph);
}

const Point origin = {0, 0, 0}, up = {0, 0, 1};
const std::vector<int> near = {3, 6, 10, 20};
Rational tenth_to(int k) {
  Rational value = 1;
  for (int i = 0; i < k; ++i) value /= 10;
  return value;
}

/// The half u -> (1 - t^2, 2 t) / (1 + t^2), t = 2 u - 1, of the circle about (x,y), extruded from z to z'.
RationalPatch half_cylinder(const Rational& x, const Rational& y, const Rational& z, const Rational& to) {
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (const Rational& height : {z, to}) {
    net[0].push_back({2 * x, 2 * y - 2, 2 * height, 2});
    net[1].push_back({2, 0, 0, 0});
    net[2].push_back({2 * x, 2 * y + 2, 2 * height, 2});
  }
  return RationalPatch::from_homogeneous(net);
}

RationalPatch bilinear(const Point& a, const Point& b, const Point& c, const Point& d) {
  return RationalPatch({{a, b}, {c, d}});
}

TEST_CASE("the half cylinder of these tests is one") {
  CHECK(surface_curve(ImplicitSurface::cylinder({5, 3, 9}, {0, 0, 7}, 1), half_cylinder(5, 3, -2, 2))
            .contains_patch);
  CHECK_FALSE(surface_curve(ImplicitSurface::cylinder({5, 3, 9}, {0, 0, 7}, Rational(11, 10)),
                            half_cylinder(5, 3, -2, 2))
                  .contains_patch);
}

TEST_CASE("Viviani's curve has a node, and beside it two arcs of either kind") {
  const RationalPatch x = half_cylinder(1, 0, -2, 2);
  const SurfaceCurve viviani = surface_curve(ImplicitSurface::sphere(origin, 2), x);
  CHECK(shape(viviani.graph) == Shape{5, 4, 1, 0, 1});
  const auto node = std::find_if(viviani.graph.nodes.begin(), viviani.graph.nodes.end(),
                                 [](const CurveNode& n) { return n.is_singular; });
  CHECK(node->u == RealAlgebraic(Rational(1, 2)));
  CHECK(sign_at(BivariatePolynomial::r() - BivariatePolynomial::constant(Rational(1, 2)), *node->exact) == 0);
  CHECK((node->left == 2 && node->right == 2));
  for (const int k : near) {
    CHECK(shape(ImplicitSurface::sphere(origin, Length::of_squared(4 + tenth_to(k))), x) ==
          Shape{4, 2, 2, 0, 0});
    CHECK(shape(ImplicitSurface::sphere(origin, Length::of_squared(4 - tenth_to(k))), x) ==
          Shape{6, 4, 2, 0, 0});
  }
}

TEST_CASE("a sphere in a bore of its radius touches along a circle") {
  const RationalPatch x = half_cylinder(0, 0, -1, 1);
  const SurfaceCurve contact = surface_curve(ImplicitSurface::sphere(origin, 1), x);
  REQUIRE(shape(contact.graph) == Shape{2, 1, 1, 0, 0});
  CHECK(contact.graph.arcs[0].multiplicity == 2);
  for (const int k : near) {
    const SurfaceCurve two = surface_curve(ImplicitSurface::sphere(origin, 1 + tenth_to(k)), x);
    CHECK(shape(two.graph) == Shape{4, 2, 2, 0, 0});
    CHECK(two.graph.arcs[0].multiplicity == 1);
    CHECK(shape(ImplicitSurface::sphere(origin, 1 - tenth_to(k)), x) == Shape{0, 0, 0, 0, 0});
  }
}

TEST_CASE("equal cylinders at right angles cross in two ellipses") {
  const RationalPatch x = half_cylinder(0, 0, -2, 2);
  CHECK(shape(ImplicitSurface::cylinder(origin, {1, 0, 0}, 1), x) == Shape{2, 2, 1, 0, 2});
  CHECK(shape(ImplicitSurface::cylinder(origin, {0, 1, 0}, 1), x) == Shape{5, 4, 1, 0, 1});
  for (const int k : near) {
    CHECK(shape(ImplicitSurface::cylinder(origin, {0, 1, 0}, 1 + tenth_to(k)), x)[4] == 0);
    CHECK(shape(ImplicitSurface::cylinder(origin, {0, 1, 0}, 1 + tenth_to(k)), x)[2] == 2);
    CHECK(shape(ImplicitSurface::cylinder(origin, {0, 1, 0}, 1 - tenth_to(k)), x)[2] == 2);
  }
}

TEST_CASE("a plane that touches a torus twice cuts it in Villarceau's circles") {
  const auto in_plane = [](const Rational& a, const Rational& b) {
    return Point{Rational(4, 5) * a, b, Rational(3, 5) * a};
  };
  const RationalPatch x =
      bilinear(in_plane(-10, -10), in_plane(-10, 10), in_plane(10, -10), in_plane(10, 10));
  CHECK(shape(ImplicitSurface::torus(origin, up, 5, 3), x) == Shape{6, 8, 1, 0, 2});
  for (const int k : near) {
    CHECK(shape(ImplicitSurface::torus(origin, up, 5, 3 + tenth_to(k)), x)[2] == 2);
    CHECK(shape(ImplicitSurface::torus(origin, up, 5, 3 + tenth_to(k)), x)[4] == 0);
    CHECK(shape(ImplicitSurface::torus(origin, up, 5, 3 - tenth_to(k)), x)[2] == 2);
    CHECK(shape(ImplicitSurface::torus(origin, up, 5, 3 - tenth_to(k)), x)[4] == 0);
  }
  // The plane on top of it touches along the circle of radius 5.
  const RationalPatch top = bilinear({-9, -9, 3}, {-9, 9, 3}, {9, -9, 3}, {9, 9, 3});
  const SurfaceCurve contact = surface_curve(ImplicitSurface::torus(origin, up, 5, 3), top);
  CHECK(shape(contact.graph) == Shape{2, 2, 1, 0, 0});
  CHECK(contact.graph.arcs[0].multiplicity == 2);
  for (const int k : near) {
    CHECK(shape(ImplicitSurface::torus(origin, up, 5, 3 + tenth_to(k)), top) == Shape{4, 4, 2, 0, 0});
    CHECK(shape(ImplicitSurface::torus(origin, up, 5, 3 - tenth_to(k)), top) == Shape{0, 0, 0, 0, 0});
  }
}

TEST_CASE("touch points, apexes and nappes") {
  const RationalPatch level = bilinear({-1, -1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, 1});
  CHECK(shape(ImplicitSurface::sphere(origin, 1), level) == Shape{1, 0, 1, 1, 1});
  for (const int k : near) {
    CHECK(shape(ImplicitSurface::sphere(origin, 1 + tenth_to(k)), level) == Shape{2, 2, 1, 0, 0});
    CHECK(shape(ImplicitSurface::sphere(origin, 1 - tenth_to(k)), level) == Shape{0, 0, 0, 0, 0});
  }
  const RationalPatch through = bilinear({0, -1, -1}, {0, -1, 1}, {0, 1, -1}, {0, 1, 1});
  CHECK(shape(ImplicitSurface::cone(origin, up, 1, 2), through) == Shape{5, 4, 1, 0, 1});
  CHECK(shape(ImplicitSurface::cone(origin, up, 1), through) == Shape{3, 2, 1, 0, 1});
  // A plane that touches the cone along a ruling, which ends in the apex of one nappe.
  const RationalPatch tangent = bilinear({-1, -1, -1}, {1, -1, 1}, {-1, 1, -1}, {1, 1, 1});
  const SurfaceCurve ruling = surface_curve(ImplicitSurface::cone(origin, up, 1), tangent);
  REQUIRE(shape(ruling.graph) == Shape{2, 1, 1, 0, 0});
  CHECK(ruling.graph.arcs[0].multiplicity == 2);
  CHECK(shape(ImplicitSurface::cone(origin, up, 1, 2), tangent) == Shape{2, 1, 1, 0, 0});
  const RationalPatch base = bilinear({-1, -1, 0}, {-1, 1, 0}, {1, -1, 0}, {1, 1, 0});
  CHECK(shape(ImplicitSurface::cone(origin, up, 1), base) == Shape{1, 0, 1, 1, 1});
}

TEST_CASE("motions over Q, inches and exchanged parameters change nothing") {
  const std::uint64_t seed = 26020;
  INFO("seed " << seed);
  Random random(seed);
  const Rational third(1, 3), inch(254, 10);
  const Point far = {from_double(1e8 + 0.1), from_double(-1e8 / 3), from_double(0.7)};
  const auto moved = [&](const Point& p) {
    return far + inch * (third * (p[0] * Point{2, 1, -2} + p[1] * Point{2, -2, 1} + p[2] * Point{1, 2, 2}));
  };
  for (int round = 0; round < 6; ++round) {
    const auto size = static_cast<std::size_t>(2 + round % 3);
    std::vector<std::vector<Point>> net(size), image(size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const double wave = 0.1 * static_cast<double>((7 * i + 5 * j + static_cast<std::size_t>(round)) % 11);
        net[i].push_back({from_double(-1.5 + 3.0 * static_cast<double>(i) / static_cast<double>(size - 1)),
                          from_double(-1.4 + 1.3 * static_cast<double>(j)), from_double(wave)});
        image[i].push_back(moved(net[i][j]));
      }
    const RationalPatch x(net), y(image);
    const ImplicitSurface here = ImplicitSurface::sphere({0, 0, Rational(1, 3)}, Rational(9, 10));
    const ImplicitSurface there =
        ImplicitSurface::sphere(moved({0, 0, Rational(1, 3)}), inch * Rational(9, 10));
    const ImplicitSurface torus = ImplicitSurface::torus(origin, {1, 1, 1}, 1, Rational(1, 3));
    INFO("round " << round);
    CHECK(shape(here, x) == shape(there, y));
    CHECK(shape(here, x) == shape(here, x.elevated(3, 3)));
    for (const ImplicitSurface& surface : {here, torus}) {
      const CurveGraph graph = surface_curve(surface, x).graph;
      const CurveGraph exchanged = surface_curve(surface, x.transposed()).graph;
      CHECK(graph.components() == exchanged.components());
      CHECK(graph.isolated_points() == exchanged.isolated_points());
      CHECK(graph.components() > 0);
    }
  }
}

}  // namespace
}  // namespace exsect::surface_curve_test
