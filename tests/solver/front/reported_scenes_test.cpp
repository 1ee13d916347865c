// Scenes rebuilt from public reports (tests/cases/reported/README.md): answers by hand, near misses beside
// them.
#include <exsect/algebra/sturm.h>
#include <exsect/geometry/number.h>
#include <exsect/geometry/surface_file.h>
#include <exsect/geometry/surface_pull_back.h>
#include <exsect/solver/intersect_equations.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>

#include "support/catch.h"

namespace exsect::reported_scenes_test {
namespace {

const NamedSurface& named(const SurfaceFile& file, const std::string& name) {
  for (const NamedSurface& entry : file.surfaces)
    if (entry.name == name) return entry;
  throw std::invalid_argument("no surface " + name);
}

/// Components by shape, and crossings.
struct Counts {
  int open = 0;
  int closed = 0;
  int branched = 0;
  int crossings = 0;
  int boundary = 0;
  bool tangential = false;  // all arcs
  int isolated = 0;
};

void check(const std::string& scene, const std::string& first, const std::string& second,
           const Counts& right) {
  INFO(scene << " " << first << " " << second);
  const SurfaceFile file = read_surfaces(std::string(EXSECT_CASES) + "/reported/" + scene + ".json");
  const IntersectResult result = intersect(*named(file, second).equation(), *named(file, first).patch());
  CHECK(result.status == Status::complete);
  const IntersectionGraph& graph = result.graph;
  CHECK(graph.count(ComponentShape::open) == right.open);
  CHECK(graph.count(ComponentShape::closed) == right.closed);
  CHECK(graph.count(ComponentShape::branched) == right.branched);
  CHECK(graph.boundary_points() == right.boundary);
  CHECK(graph.isolated_points.size() == static_cast<std::size_t>(right.isolated));
  CHECK(graph.overlaps.empty());
  CHECK(std::count_if(graph.nodes.begin(), graph.nodes.end(), [](const Node& node) {
          return std::count(node.kinds.begin(), node.kinds.end(), NodeKind::crossing) > 0;
        }) == right.crossings);
  for (const Arc& arc : graph.arcs) CHECK((arc.contact == Contact::tangential) == right.tangential);
}

const std::vector<std::string> distances = {"3", "6", "12", "20"};

}  // namespace

TEST_CASE("reported scenes: two branches cross where round surfaces touch") {
  // On the patch z^2 is a t^2 + O(t^4), a > 0, and near misses add a small constant of the sign of the name:
  // two branches beside each other above and below, or to the left and to the right.
  for (const std::string scene :
       {"viviani", "equal-cylinders", "torus-outer-equator", "torus-inner-equator"}) {
    check(scene, "x", "y", {.branched = 1, .crossings = 1, .boundary = 4});
    for (const std::string& distance : distances) {
      check(scene, "x", "y+" + distance, {.open = 2, .boundary = 4});
      check(scene, "x", "y-" + distance, {.open = 2, .boundary = 4});
    }
  }
}

TEST_CASE("reported scenes: contact along a line or a circle") {
  const Counts touching = {.open = 1, .boundary = 2, .tangential = true};
  const Counts twice = {.open = 2, .boundary = 4};
  check("cylinders-along-a-line", "x", "y", touching);
  check("sphere-in-a-bore", "x", "y", touching);
  check("torus-on-a-plane", "x", "y", {.closed = 1, .tangential = true});
  // Outside of the circle of centres the torus is at (R + cos, 0, sin) alone: elsewhere on the cylinder the
  // distance from the axis is greater.
  check("pipe-corner", "x", "y", touching);
  check("cube-and-cylinder", "x", "y", touching);
  check("cube-and-cylinder", "x", "face", touching);  // from the cube's top, inside of the patch, upwards
  for (const std::string& distance : distances) {
    check("cylinders-along-a-line", "x", "y+" + distance, {});
    check("cylinders-along-a-line", "x", "y-" + distance, twice);
    check("pipe-corner", "x", "y+" + distance, twice);
    check("pipe-corner", "x", "y-" + distance, {});
    check("cube-and-cylinder", "x", "y+" + distance, twice);
    check("cube-and-cylinder", "x", "y-" + distance, {});
    check("sphere-in-a-bore", "x", "y+" + distance, twice);
    check("sphere-in-a-bore", "x", "y-" + distance, {});
    check("torus-on-a-plane", "x", "y+" + distance, {.closed = 2});
    check("torus-on-a-plane", "x", "y-" + distance, {});
  }
}

TEST_CASE("reported scenes: Villarceau's circles") {
  check("villarceau", "x", "y", {.branched = 1, .crossings = 2});
  // The two double points open in opposite ways, as half a turn about the axis y exchanges them and the
  // sides.
  for (const std::string& distance : distances)
    for (const std::string sign : {"+", "-"}) check("villarceau", "x" + sign + distance, "y", {.closed = 1});
}

TEST_CASE("reported scenes: a rod through a torus") {
  // x = +- sqrt((10 +- sqrt(9 - z^2))^2 - y^2) over all of the arc.
  check("torus-and-rod", "x", "y", {.open = 4, .boundary = 8});
}

namespace {

/// How many points of the torus are on each of 60 lines of the cylinder, by a Sturm sequence; the same on
/// all.
int points_on_generatrices(const ImplicitSurface& torus, const ImplicitSurface& cylinder) {
  const Point axis = cylinder.data()->axis;
  const std::array<double, 3> d = {to_double(axis[0]), to_double(axis[1]), to_double(axis[2])};
  const double length = std::hypot(d[0], d[1], d[2]), flat = std::hypot(d[1], d[2]);
  const bool along_x = flat == 0;
  const std::array<double, 3> a = {0, along_x ? 1 : d[2] / flat, along_x ? 0 : -d[1] / flat};
  const std::array<double, 3> b = {(d[1] * a[2] - d[2] * a[1]) / length, -d[0] * a[2] / length,
                                   d[0] * a[1] / length};
  const double radius = std::sqrt(to_double(cylinder.data()->squared));
  std::set<int> counts;
  for (int i = 0; i < 60; ++i) {
    const double angle = std::numbers::pi * i / 30;
    Point start = cylinder.data()->point;
    for (std::size_t k = 0; k < 3; ++k)
      start[k] += Rational(radius * (std::cos(angle) * a[k] + std::sin(angle) * b[k]));
    counts.insert(SturmSequence(pull_back(torus.equation(), start, axis)).count_all());
  }
  REQUIRE(counts.size() == 1);
  return *counts.begin();
}

void check_pierced(const std::string& scene, const std::string& first, const std::string& second,
                   int curves) {
  INFO(scene << " " << first << " " << second);
  const SurfaceFile file = read_surfaces(std::string(EXSECT_CASES) + "/reported/" + scene + ".json");
  const ImplicitSurface &torus = *named(file, first).equation(), &rod = *named(file, second).equation();
  CHECK(points_on_generatrices(torus, rod) == curves);
  for (const SurfaceIntersection& result : {intersect(torus, rod), intersect(rod, torus)}) {
    CHECK(result.status == Status::complete);
    CHECK(result.curves.size() == static_cast<std::size_t>(curves));
    for (const SpaceCurve& curve : result.curves) CHECK((curve.is_closed && curve.multiplicity == 1));
    CHECK(result.count(SpaceNodeKind::crossing) == 0);
  }
}

}  // namespace

TEST_CASE("reported scenes: rods through tori, a closed curve for each point of a generatrix") {
  for (const std::string torus : {"inner", "outer"})
    for (const std::string rod : {"rod", "moved"}) check_pierced("torus-and-thin-rod", torus, rod, 2);
  for (const std::string rod : {"quarter", "fifth"}) check_pierced("pierced-torus", "torus", rod, 4);
  // As thick as the torus: inside and outside curves meet where both are tangent to the planes y = +-20.
  const SurfaceFile file = read_surfaces(std::string(EXSECT_CASES) + "/reported/pierced-torus.json");
  const SurfaceIntersection whole =
      intersect(*named(file, "torus").equation(), *named(file, "whole").equation());
  CHECK(whole.status == Status::complete);
  CHECK(whole.count(SpaceNodeKind::crossing) == 4);
}

TEST_CASE("reported scenes: bicubic bumps that share sides, in whole and in part") {
  const SurfaceFile file = read_surfaces(std::string(EXSECT_CASES) + "/reported/bumps-on-one-square.json");
  const auto patch = [&](const char* name) { return *named(file, name).patch(); };
  for (const bool exchanged : {false, true}) {
    const auto solve = [&](const char* other) {
      return exchanged ? intersect(patch(other), patch("x")) : intersect(patch("x"), patch(other));
    };
    const IntersectResult rim = solve("below");  // z = 45 u(1-u)v(1-v) and -18 u(1-u)v(1-v)
    CHECK(rim.status == Status::complete);
    CHECK(rim.graph.arcs.size() == 4);
    CHECK(rim.graph.count(ComponentShape::closed) == 1);
    // Two sides in part, and 10 (1-u)(1-v) = (1-u/2)(1-v/2) from (18/19, 0) to (0, 18/19).
    const IntersectResult part = solve("larger");
    CHECK(part.status == Status::complete);
    CHECK(part.graph.arcs.size() == 5);
    CHECK(part.graph.nodes.size() == 5);
    int inner = 0;
    for (const Arc& arc : part.graph.arcs) {
      if (arc.place != ArcPlace::interior) continue;
      ++inner;
      for (const PolylineVertex& vertex : arc.polyline) {
        const std::size_t k = exchanged ? 2 : 0;
        const double u = vertex.parameters[k], v = vertex.parameters[k + 1];
        CHECK(std::fabs(10 * (1 - u) * (1 - v) - (1 - u / 2) * (1 - v / 2)) < 1e-9);
      }
    }
    CHECK(inner == 1);
  }
}

TEST_CASE("reported scenes: a cone taken from a block") {
  // The top z = 0 cuts out the circle of radius 5 about the axis, the side x = 10 the hyperbola
  // (z + 5)^2 = (10 - a)^2 + (y - b)^2 of the axis (a, b).
  const std::string scene = "cone-in-a-block";
  const Counts one_arc = {.open = 1, .boundary = 2};
  check(scene, "top", "inside", {.closed = 1});
  check(scene, "side", "inside", {});
  check(scene, "top", "across", one_arc);
  check(scene, "side", "across", one_arc);
  // The circle touches the edge from inside, the hyperbola's vertex is on the edge.
  check(scene, "top", "touching", {.closed = 1, .boundary = 1});
  check(scene, "side", "touching", {.boundary = 1, .isolated = 1});
  for (const std::string& distance : distances) {
    check(scene, "top", "touching+" + distance, one_arc);
    check(scene, "side", "touching+" + distance, one_arc);
    check(scene, "top", "touching-" + distance, {.closed = 1});
    check(scene, "side", "touching-" + distance, {});
  }
  // The circle passes by the corner (10, 10) outside, the hyperbola ends there.
  check(scene, "top", "on-a-corner", {.open = 1, .boundary = 3, .isolated = 1});
  check(scene, "side", "on-a-corner", one_arc);
}

namespace {

/// How the circle of the given squared radius about (a, b) lies in the rectangle [from, to] x [0, 10]: its
/// points on the sides, none in a corner and none where it touches a side, and whether it is inside without
/// any.
struct CircleInRectangle {
  int on_sides = 0;
  bool inside = false;
};

CircleInRectangle circle_in_rectangle(const Rational& a, const Rational& b, const Rational& squared, int from,
                                      int to) {
  CircleInRectangle result;
  const auto count = [&](const Rational& distance, const Rational& centre, int low, int high) {
    const Rational rest = squared - distance * distance;
    REQUIRE(rest != 0);
    if (rest < 0) return;
    // centre - sqrt(rest) and centre + sqrt(rest), compared with an end e by the signs of e - centre and of
    // (e - centre)^2 - rest.
    const auto is_above = [&](int end, int sign) {  // of the end, of the point with this sign
      const Rational gap = centre - end, excess = gap * gap - rest;
      REQUIRE(excess != 0);
      return excess > 0 ? gap > 0 : sign > 0;
    };
    for (const int sign : {-1, 1}) result.on_sides += is_above(low, sign) && !is_above(high, sign) ? 1 : 0;
  };
  count(a - from, b, 0, 10);
  count(a - to, b, 0, 10);
  count(b, a, from, to);
  count(b - 10, a, from, to);
  result.inside =
      result.on_sides == 0 && a > from && a < to && b > 0 && b < 10 && (a - from) * (a - from) > squared;
  return result;
}

}  // namespace

TEST_CASE("reported scenes: sections of two top faces by a cylinder at many places") {
  // The faces are graphs over rectangles, so that sections are parts of circles in projection.
  const SurfaceFile file =
      read_surfaces(std::string(EXSECT_CASES) + "/reported/sections-at-many-places.json");
  const SurfaceData& cylinder = *named(file, "cylinder").equation()->data();
  const unsigned seed = 24115;
  INFO("seed " << seed);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> along(-1, 21), across(-1, 11);
  int closed = 0, cut = 0;
  for (int i = 0; i < 100; ++i) {
    const double a = along(engine), b = across(engine);
    INFO("place " << a << " " << b);
    const ImplicitSurface moved = ImplicitSurface::cylinder({Rational(a), Rational(b), 0}, cylinder.axis,
                                                            Length::of_squared(cylinder.squared));
    for (const bool is_left : {true, false}) {
      const CircleInRectangle right = circle_in_rectangle(Rational(a), Rational(b), cylinder.squared,
                                                          is_left ? 0 : 10, is_left ? 10 : 20);
      const IntersectResult result = intersect(moved, *named(file, is_left ? "left" : "right").patch());
      CHECK(result.status == Status::complete);
      CHECK(result.graph.boundary_points() == right.on_sides);
      CHECK(result.graph.count(ComponentShape::open) == right.on_sides / 2);
      CHECK(result.graph.count(ComponentShape::closed) == (right.inside ? 1 : 0));
      closed += right.inside ? 1 : 0;
      cut += right.on_sides > 0 ? 1 : 0;
    }
  }
  CHECK(closed > 20);
  CHECK(cut > 20);
}

namespace {

/// How many points of the patch's sides are on the face: roots by Sturm sequences in 1024 cells of each side.
/// The middle of its cell says whether a root is on the face, so none may be that near to the face's rim.
int points_on_sides(const RationalPatch& patch, const ImplicitSurface& face) {
  const BivariatePolynomial f = pull_back(face.equation(), patch);
  int points = 0;
  for (const int end : {0, 1})
    for (const bool along_u : {true, false}) {
      const SturmSequence roots(along_u ? f.at_s(end) : f.at_r(end));
      for (int i = 0; i < 1024; ++i) {
        const int found = roots.count(Rational(i, 1024), Rational(i + 1, 1024));
        const Rational t(2 * i + 1, 2048);
        if (found > 0 && face.box().contains(along_u ? patch(t, end) : patch(end, t))) points += found;
      }
    }
  return points;
}

void check_open(const IntersectResult& result, int curves) {
  CHECK(result.status == Status::complete);
  CHECK(result.graph.count(ComponentShape::open) == curves);
  CHECK(result.graph.components.size() == static_cast<std::size_t>(curves));
  CHECK(result.graph.boundary_points() == 2 * curves);
  CHECK(result.graph.isolated_points.empty());
  CHECK(result.graph.overlaps.empty());
}

void check_on_face(const RationalPatch& patch, const ImplicitSurface& face) {
  CHECK(pull_back(face.equation(), patch).is_zero());
  for (const int u : {0, 1})
    for (const int v : {0, 1}) CHECK(face.contains(patch(u, v)));
}

/// Two patches without a closed curve between them, and the same as faces: as many ends as points of the
/// sides of one on the other.
void check_faces(const SurfaceFile& file, const std::string& first, const std::string& second, int curves) {
  INFO(first << " " << second);
  const RationalPatch &x = *named(file, first).patch(), &y = *named(file, second).patch();
  const ImplicitSurface& first_face = *named(file, first + " face").equation();
  const ImplicitSurface& second_face = *named(file, second + " face").equation();
  check_on_face(x, first_face);
  check_on_face(y, second_face);
  CHECK(points_on_sides(x, second_face) + points_on_sides(y, first_face) == 2 * curves);
  check_open(intersect(x, y), curves);
  check_open(intersect(y, x), curves);
  check_open(intersect(second_face, x), curves);
  check_open(intersect(first_face, y), curves);
  const SurfaceIntersection faces = intersect(first_face, second_face);
  CHECK(faces.status == Status::complete);
  CHECK(faces.curves.size() == static_cast<std::size_t>(curves));
  for (const SpaceCurve& curve : faces.curves) CHECK_FALSE(curve.is_closed);
}

}  // namespace

TEST_CASE("reported scenes: torus, cylinder and sphere as biquadratic patches with weights 1, 1, 2") {
  const SurfaceFile file = read_surfaces(std::string(EXSECT_CASES) + "/reported/three-weighted-patches.json");
  check_faces(file, "torus", "cylinder", 2);
  check_faces(file, "torus", "sphere", 1);
  check_faces(file, "cylinder", "sphere", 1);
}

}  // namespace exsect::reported_scenes_test
