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
  IntersectOptions exactly;
  exactly.exact = true;  // as boxes are
  const IntersectionGraph whole = intersect(pipe, x, exactly).graph;
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

/// Of the one overlap that there is: the lengths of its chains, of every arc in space.
std::vector<double> rim_lengths(const IntersectResult& result) {
  REQUIRE(result.graph.overlaps.size() == 1);
  std::vector<double> lengths;
  for (const std::vector<Arc>& chain : result.graph.overlaps[0].chains) {
    IntersectionGraph of;
    of.arcs = chain;
    lengths.push_back(length_of(of));
    for (std::size_t k = 0; k < chain.size(); ++k) CHECK(chain[k].to == chain[(k + 1) % chain.size()].from);
  }
  return lengths;
}

TEST_CASE("patches on the surface of a box: what the box leaves of them") {
  const RationalPatch quarter = quarter_cylinder();
  const double arc = std::acos(0);
  const auto rim = [&](const SurfaceBox& box) { return rim_lengths(complete(boxed(pipe, box), quarter)); };
  const auto near = [](const std::vector<double>& lengths, double length) {
    return lengths.size() == 1 && std::fabs(lengths[0] - length) < 1e-4;
  };
  CHECK(near(rim(height(-1, 2)), 2 * arc + 2));
  CHECK(near(rim(height(Rational(1, 3), 2)), 2 * arc + 4.0 / 3));
  CHECK(near(rim(height(Rational(1, 3), Rational(1, 2))), 2 * arc + 1.0 / 3));
  CHECK(near(rim(sector(east, {1, 1, 0})), arc + 2));
  CHECK(near(rim(sector({1, 1, 7}, west)), arc + 2));
  CHECK(near(rim({.sector = AxisSector{{4, 3, 0}, {3, 4, 0}}, .height = HeightRange{Rational(1, 2), 3}}),
             2 * std::asin(0.28) + 1));
  // A sector of nearly a whole turn leaves two parts.
  const IntersectResult parts = complete(boxed(pipe, sector({3, 4, 0}, {4, 3, 0})), quarter);
  REQUIRE(parts.graph.overlaps.size() == 2);
  for (const Overlap& overlap : parts.graph.overlaps) CHECK(overlap.chains.size() == 1);
  CHECK(bounds_of(parts) == Names{"sector=from", "sector=from", "sector=to", "sector=to"});
  // On its bounds alone: a side, a corner, nothing.
  const IntersectResult side = complete(boxed(pipe, height(1, 2)), quarter);
  CHECK(shape(side.graph) == std::array<int, 4>{1, 0, 0, 0});
  CHECK(std::fabs(length_of(side.graph) - arc) < 1e-4);
  CHECK(bounds_of(side) == Names{"height=from", "height=from"});
  const IntersectResult corner =
      complete(boxed(pipe, {.sector = AxisSector{north, west}, .height = HeightRange{1, 2}}), quarter);
  CHECK(shape(corner.graph) == std::array<int, 4>{0, 0, 0, 1});
  CHECK(bounds_of(corner) == Names{"height=from", "sector=from"});
  Rational off = 1;
  for (int k = 1; k <= 20; ++k) off /= 10;
  CHECK(shape(complete(boxed(pipe, height(1 + off, 2)), quarter).graph) == std::array<int, 4>{0, 0, 0, 0});
  const IntersectResult sliver = complete(boxed(pipe, height(1 - off, 2)), quarter);
  CHECK(near(rim_lengths(sliver), 2 * arc));
}

TEST_CASE("patches on the surface of a box: a parallelogram, and one nappe of two") {
  const ImplicitSurface cone = ImplicitSurface::cone(origin, up, 1);
  // Both nappes of x^2 + y^2 = z^2 over a quarter turn: radius and height run from -1 to 1.
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (const int z : {-1, 1}) {
    net[0].push_back({z, 0, z, 1});
    net[1].push_back({z, z, z, 1});
    net[2].push_back({0, 2 * z, 2 * z, 2});
  }
  const RationalPatch both = RationalPatch::from_homogeneous(net);
  const IntersectResult upper = complete(cone, both);
  CHECK(rim_lengths(upper).size() == 1);
  CHECK(std::fabs(rim_lengths(upper)[0] - std::acos(0) - 2 * std::sqrt(2.0)) < 1e-4);
  const IntersectResult all = complete(ImplicitSurface::cone(origin, up, 1, 2), both);
  CHECK(std::fabs(rim_lengths(all)[0] - 2 * std::acos(0) - 4 * std::sqrt(2.0)) < 1e-4);
  // A parallelogram inside of a plane patch.
  const ImplicitSurface floor = ImplicitSurface::plane(origin, up);
  const SurfaceBox tile{.sides = std::array{Point{1, 0, 0}, Point{1, 1, 0}}};
  CHECK(std::fabs(rim_lengths(complete(boxed(floor, tile), level(0)))[0] - 2 - 2 * std::sqrt(2.0)) < 1e-4);
}

TEST_CASE("patches on the surface: in the box, or beside it") {
  const RationalPatch quarter = quarter_cylinder();
  const ImplicitSurface face = boxed(pipe, {.sector = AxisSector{east, north}, .height = HeightRange{0, 1}});
  CHECK(complete(face, quarter).graph.overlaps.size() == 1);
  CHECK(complete(boxed(pipe, height(2, 3)), quarter).graph.overlaps.empty());
  CHECK(intersect(face, face).is_same);
  // The face is a part of the whole surface.
  const SurfaceIntersection part = intersect(face, pipe);
  CHECK(part.status == Status::complete);
  CHECK(part.is_same);
}

}  // namespace
}  // namespace exsect::intersect_face_test
