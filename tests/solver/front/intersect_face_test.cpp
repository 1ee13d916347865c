#include <exsect/geometry/surface_box.h>
#include <exsect/solver/intersect_equations.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <cmath>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::intersect_face_test {
namespace {

const Point origin = {0, 0, 0}, up = {0, 0, 1};
const Point east = {1, 0, 0}, north = {0, 1, 0}, west = {-1, 0, 0}, south = {0, -1, 0};

SurfaceBox sector(const Point& from, const Point& to) { return {.sector = AxisSector{from, to}}; }
SurfaceBox height(const Rational& from, const Rational& to) { return {.height = HeightRange{from, to}}; }

RationalPatch bilinear(const Point& a, const Point& b, const Point& c, const Point& d) {
  return RationalPatch({{a, b}, {c, d}});
}
/// At this height, over [-2,2]^2.
RationalPatch level(const Rational& z) { return bilinear({-2, -2, z}, {-2, 2, z}, {2, -2, z}, {2, 2, z}); }

/// The quarter of the cylinder of radius 1 about the axis z from east to north, z in [0,1].
RationalPatch quarter_cylinder() {
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (const int z : {0, 1}) {
    net[0].push_back({1, 0, z, 1});
    net[1].push_back({1, 1, z, 1});
    net[2].push_back({0, 2, 2 * z, 2});
  }
  return RationalPatch::from_homogeneous(net);
}

double length_of(const IntersectionGraph& graph) {
  double sum = 0;
  for (const Arc& arc : graph.arcs)
    for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i) {
      double squared = 0;
      for (std::size_t k = 0; k < 3; ++k)
        squared += std::pow(arc.polyline[i + 1].point[k] - arc.polyline[i].point[k], 2);
      sum += std::sqrt(squared);
    }
  return sum;
}

IntersectResult complete(const ImplicitSurface& surface, const RationalPatch& x) {
  IntersectOptions options;
  options.tolerance = 1e-6;
  IntersectResult result = intersect(surface, x, options);
  for (const Incomplete& reason : result.incomplete) UNSCOPED_INFO(reason.why);
  REQUIRE(result.status == Status::complete);
  return result;
}

/// All names of bounds at the nodes, ascending.
std::vector<std::string> bounds_of(const IntersectResult& result) {
  std::vector<std::string> names;
  for (const Node& node : result.graph.nodes) {
    names.insert(names.end(), node.bounds.begin(), node.bounds.end());
    const auto& kinds = node.kinds;
    CHECK(std::ranges::count(kinds, NodeKind::boundary) == (node.bounds.size() + node.on.size() > 0 ? 1 : 0));
  }
  std::ranges::sort(names);
  return names;
}
using Names = std::vector<std::string>;

/// Open, closed and branched components, isolated points.
std::array<int, 4> shape(const IntersectionGraph& g) {
  return {g.count(ComponentShape::open), g.count(ComponentShape::closed), g.count(ComponentShape::branched),
          static_cast<int>(g.isolated_points.size())};
}

const ImplicitSurface pipe = ImplicitSurface::cylinder(origin, up, 1);

TEST_CASE("sectors of a cylinder in a plane: arcs of known length between named ends") {
  const auto in_sector = [&](const Point& from, const Point& to) {
    return complete(boxed(pipe, sector(from, to)), level(Rational(1, 2)));
  };
  for (const auto& [from, to, part] :
       std::vector<std::tuple<Point, Point, double>>{{east, north, 0.25},
                                                     {north, west, 0.25},
                                                     {east, west, 0.5},
                                                     {south, north, 0.5},
                                                     {east, south, 0.75},
                                                     {Point{1, 1, 4}, Point{1, -1, 5}, 0.75},
                                                     {Point{3, 4, 0}, Point{-3, -4, 1}, 0.5}}) {
    const IntersectResult result = in_sector(from, to);
    CHECK(shape(result.graph) == std::array{1, 0, 0, 0});
    CHECK(std::fabs(length_of(result.graph) - 2 * M_PI * part) < 1e-3);
    CHECK(bounds_of(result) == Names{"sector=from", "sector=to"});
  }
}

TEST_CASE("heights cut, touch and miss what they should") {
  const RationalPatch slope = bilinear({-2, -2, -2}, {-2, 2, -2}, {2, -2, 2}, {2, 2, 2});  // z = x
  CHECK(shape(complete(boxed(pipe, height(-1, 1)), slope).graph) == std::array{0, 1, 0, 0});
  CHECK(bounds_of(complete(boxed(pipe, height(-1, 1)), slope)) == Names{"height=from", "height=to"});
  const IntersectResult two = complete(boxed(pipe, height(Rational(-1, 2), Rational(1, 2))), slope);
  CHECK(shape(two.graph) == std::array{2, 0, 0, 0});
  CHECK(bounds_of(two) == Names{"height=from", "height=from", "height=to", "height=to"});
  const IntersectResult touch = complete(boxed(pipe, height(1, 2)), slope);
  CHECK(shape(touch.graph) == std::array{0, 0, 0, 1});
  CHECK(bounds_of(touch) == Names{"height=from"});
  CHECK_FALSE(touch.graph.nodes[0].around.has_value());
  CHECK(complete(boxed(pipe, height(Rational(1001, 1000), 2)), slope).graph.nodes.empty());
  // Along the upper rim itself.
  const IntersectResult rim = complete(boxed(pipe, height(0, 1)), level(1));
  CHECK(shape(rim.graph) == std::array{0, 1, 0, 0});
  for (const Node& node : rim.graph.nodes) CHECK(node.bounds == Names{"height=to"});
}

TEST_CASE("along the rim of a half turn nodes lie on the side that they are on, and the poles on both") {
  const ImplicitSurface ball = ImplicitSurface::sphere(origin, 1);
  SurfaceBox half = sector(east, west);
  half.axis = up;
  for (const RationalPatch& x : {bilinear({-3, 0, -2}, {-1, 0, 3}, {1, 0, -3}, {3, 0, 2}),
                                 bilinear({-2, 0, -2}, {-2, 0, 2}, {2, 0, -2}, {2, 0, 2}),
                                 bilinear({-2, 0, -3}, {-2, -1, 3}, {2, 1, -3}, {2, 0, 3}),
                                 bilinear({-2, 0, -2}, {-2, 1, 2}, {2, 0, -2}, {2, 1, 2})}) {
    const IntersectResult rim = complete(boxed(ball, half), x);
    int poles = 0;
    for (const Node& node : rim.graph.nodes) {
      if (std::fabs(node.point[1]) > 1e-9) continue;
      const double east_of_axis = node.point[0];
      if (std::fabs(east_of_axis) < 1e-12) {
        CHECK(node.bounds == Names{"sector=from", "sector=to"});
        ++poles;
      } else {
        CHECK(node.bounds == Names{east_of_axis > 0 ? "sector=from" : "sector=to"});
      }
    }
    if (std::ranges::all_of(rim.graph.nodes, [](const Node& n) { return std::fabs(n.point[1]) < 1e-9; }))
      CHECK(poles == 2);
  }
}

TEST_CASE("a box that holds all of the curve leaves the graph of the whole surface") {
  const RationalPatch x = bilinear({-2, -2, 0}, {-2, 2, Rational(1, 3)}, {2, -2, 1}, {2, 2, Rational(1, 5)});
  const IntersectionGraph whole = complete(pipe, x).graph;
  for (const SurfaceBox& box : {height(-9, 9), SurfaceBox{.height = HeightRange{-5, Rational(7, 2)}}}) {
    const IntersectionGraph part = complete(boxed(pipe, box), x).graph;
    REQUIRE(part.nodes.size() == whole.nodes.size());
    REQUIRE(part.arcs.size() == whole.arcs.size());
    for (std::size_t i = 0; i < whole.arcs.size(); ++i) {
      CHECK(part.arcs[i].from == whole.arcs[i].from);
      CHECK(part.arcs[i].beside == whole.arcs[i].beside);
      CHECK(part.arcs[i].polyline.size() == whole.arcs[i].polyline.size());
    }
  }
}

TEST_CASE("faces of cones, spheres and tori in planes") {
  const ImplicitSurface cone = ImplicitSurface::cone(origin, up, 1);
  const RationalPatch upright = bilinear({0, -2, -2}, {0, -2, 2}, {0, 2, -2}, {0, 2, 2});
  CHECK(shape(complete(boxed(cone, height(0, 1)), upright).graph) == std::array{1, 0, 0, 0});
  CHECK(shape(complete(boxed(cone, height(Rational(1, 2), 1)), upright).graph) == std::array{2, 0, 0, 0});
  const IntersectResult ruling = complete(boxed(cone, sector({1, 1, 0}, {-1, 1, 0})), upright);
  CHECK(shape(ruling.graph) == std::array{1, 0, 0, 0});
  const ImplicitSurface ball = ImplicitSurface::sphere(origin, 1);
  SurfaceBox cap = height(Rational(3, 5), 2);
  cap.axis = up;
  const IntersectResult bow = complete(boxed(ball, cap), upright);
  CHECK(shape(bow.graph) == std::array{1, 0, 0, 0});
  CHECK(std::fabs(length_of(bow.graph) - 2 * std::acos(0.6)) < 1e-3);
  cap.sector = AxisSector{{1, 1, 0}, {-1, 1, 0}};
  CHECK(std::fabs(length_of(complete(boxed(ball, cap), upright).graph) - std::acos(0.6)) < 1e-3);
  const ImplicitSurface ring = ImplicitSurface::torus(origin, Rational(7) * up, 3, 1);
  const RationalPatch wide = bilinear({-5, -5, 0}, {-5, 5, 0}, {5, -5, 0}, {5, 5, 0});
  const auto tube = [&](const std::array<Rational, 2>& from, const std::array<Rational, 2>& to) {
    return complete(boxed(ring, {.tube = TubeSector{from, to}}), wide).graph;
  };
  CHECK(shape(complete(ring, wide).graph) == std::array{0, 2, 0, 0});
  CHECK(std::fabs(length_of(tube({0, 1}, {0, -1})) - 4 * M_PI) < 1e-2);
  CHECK(std::fabs(length_of(tube({0, -1}, {0, 1})) - 8 * M_PI) < 1e-2);
  CHECK(shape(tube({1, 1}, {-1, 1})) == std::array{0, 0, 0, 0});
  CHECK(shape(tube({-1, 1}, {1, 1})) == std::array{0, 2, 0, 0});
}

TEST_CASE("a corner of a box is both of its bounds, and complementary boxes make up the whole") {
  // The plane passes through (1,0,1), where the sector begins and the height ends.
  const RationalPatch x = bilinear({-2, -2, 4}, {-2, 2, 4}, {2, -2, 0}, {2, 2, 0});  // z = 2 - x
  const ImplicitSurface face = boxed(pipe, {.sector = AxisSector{east, west}, .height = HeightRange{1, 2}});
  CHECK(bounds_of(complete(face, x)) == Names{"height=from", "height=to", "sector=from"});
  const std::uint64_t seed = 28021;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 6; ++round) {
    const Point from = random_point(random), to = random_point(random);
    if (cross(from, to)[2] == 0) continue;
    const double one = length_of(complete(boxed(pipe, sector(from, to)), x).graph);
    const double other = length_of(complete(boxed(pipe, sector(to, from)), x).graph);
    CHECK(std::fabs(one + other - length_of(complete(pipe, x).graph)) < 1e-3);
  }
}

TEST_CASE("a quarter of a cylinder by its equation meets what the weighted patch meets") {
  const std::uint64_t seed = 28022;
  INFO("seed " << seed);
  Random random(seed);
  const RationalPatch quarter = quarter_cylinder();
  const ImplicitSurface whole = ImplicitSurface::cylinder(origin, up, 1);
  const ImplicitSurface face = boxed(whole, {.sector = AxisSector{east, north}, .height = HeightRange{0, 1}});
  const auto near_face = [&] {
    return Point{random_rational(random, 3) / 2, random_rational(random, 3) / 2,
                 random_rational(random, 3) / 2};
  };
  int arcs = 0;
  for (int round = 0; round < 30; ++round) {
    const RationalPatch x = bilinear(near_face(), near_face(), near_face(), near_face());
    const IntersectResult by_patch = intersect(x, quarter, {});
    if (by_patch.status != Status::complete || !by_patch.graph.overlaps.empty()) continue;
    const IntersectResult by_equation = complete(face, x);
    CHECK(shape(by_equation.graph) == shape(by_patch.graph));
    CHECK(std::fabs(length_of(by_equation.graph) - length_of(by_patch.graph)) < 1e-2);
    arcs += static_cast<int>(by_equation.graph.arcs.size());
  }
  CHECK(arcs > 5);
}

TEST_CASE("faces far away, turned and in inches have the same curves") {
  const Rational third(1, 3), inch(254, 10);
  const Point far = {from_double(1e8 + 0.1), from_double(-1e8 / 3), from_double(0.7)};
  const auto turned = [&](const Point& p) {
    return third * (p[0] * Point{2, 1, -2} + p[1] * Point{2, -2, 1} + p[2] * Point{-1, -2, -2});
  };
  const auto moved = [&](const Point& p) { return far + inch * turned(p); };
  const auto slope = [&](const auto& at) {
    return bilinear(at(Point{-2, -2, -2}), at(Point{-2, 2, -1}), at(Point{2, -2, 1}), at(Point{2, 2, 2}));
  };
  const IntersectResult here = complete(
      boxed(pipe, {.sector = AxisSector{{1, 2, 0}, {1, -2, 0}}, .height = HeightRange{Rational(-1, 2), 1}}),
      slope([](const Point& p) { return p; }));
  const ImplicitSurface there = boxed(ImplicitSurface::cylinder(far, inch * turned(up), inch),
                                      {.sector = AxisSector{turned({1, 2, 0}), turned({1, -2, 0})},
                                       .height = HeightRange{Rational(-1, 2), 1}});
  const IntersectResult other = complete(there, slope(moved));
  CHECK(shape(here.graph) == shape(other.graph));
  CHECK(bounds_of(here) == bounds_of(other));
  CHECK_FALSE(here.graph.arcs.empty());
  CHECK(here.graph.nodes.size() == other.graph.nodes.size());
}

TEST_CASE("patches on the surface: in the box, beside it, or not decided") {
  const RationalPatch quarter = quarter_cylinder();
  const ImplicitSurface face = boxed(pipe, {.sector = AxisSector{east, north}, .height = HeightRange{0, 1}});
  CHECK(complete(face, quarter).graph.overlaps.size() == 1);
  CHECK(complete(boxed(pipe, height(2, 3)), quarter).graph.overlaps.empty());
  CHECK(intersect(boxed(pipe, height(Rational(1, 2), 3)), quarter).status == Status::incomplete);
  CHECK(intersect(face, face).is_same);
  CHECK(intersect(face, pipe).status == Status::incomplete);
}

}  // namespace
}  // namespace exsect::intersect_face_test
