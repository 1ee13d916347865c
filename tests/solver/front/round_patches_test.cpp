// Quarters of cylinders, cones, spheres and tori, with weights 1, 1, 2, and planes as they stand in models:
// along the axes, where parameters are constant, turn at the ends of curves, or turn together.
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <cmath>

#include "support/catch.h"

namespace exsect::round_patches_test {
namespace {

using Profile = std::vector<std::array<Rational, 2>>;  // radius, height

const std::vector<std::array<Rational, 2>> quarter = {{1, 0}, {1, 1}, {0, 1}};
const std::vector<Rational> quarter_weights = {1, 1, 2};

/// A profile revolved by a quarter about the axis in direction `axis` through a point.
RationalPatch revolved(const Profile& profile, const std::vector<Rational>& weights, std::size_t axis,
                       const Point& through) {
  std::vector<std::vector<Point>> points;
  std::vector<std::vector<Rational>> all;
  for (std::size_t i = 0; i < 3; ++i) {
    points.emplace_back();
    all.emplace_back();
    for (std::size_t j = 0; j < profile.size(); ++j) {
      Point p = through;
      p[axis] += profile[j][1];
      p[(axis + 1) % 3] += profile[j][0] * quarter[i][0];
      p[(axis + 2) % 3] += profile[j][0] * quarter[i][1];
      points.back().push_back(p);
      all.back().push_back(quarter_weights[i] * weights[j]);
    }
  }
  return RationalPatch(points, all);
}

RationalPatch cylinder(std::size_t axis, const Point& through, const Rational& radius, const Rational& from,
                       const Rational& to) {
  return revolved({{radius, from}, {radius, to}}, {1, 1}, axis, through);
}
RationalPatch cone() { return revolved({{1, 0}, {0, 1}}, {1, 1}, 2, {0, 0, 0}); }
RationalPatch sphere() { return revolved({{1, 0}, {1, 1}, {0, 1}}, quarter_weights, 2, {0, 0, 0}); }
RationalPatch torus() { return revolved({{4, 0}, {4, 1}, {3, 1}}, quarter_weights, 2, {0, 0, 0}); }

RationalPatch plane(const Point& origin, const Point& a, const Point& b) {
  return RationalPatch(std::vector<std::vector<Point>>{{origin, origin + b}, {origin + a, origin + a + b}});
}

struct Scene {
  const char* name;
  RationalPatch x;
  RationalPatch y;
  std::array<int, 4> turning;  // by calculus
};

std::vector<Scene> scenes() {
  const Rational h(1, 2);
  const RationalPatch level = plane({-1, -1, h}, {9, 0, 0}, {0, 9, 0});
  const RationalPatch tilted = plane({-1, -1, Rational(1, 4)}, {3, 0, Rational(3, 4)}, {0, 3, 0});
  const auto upright = [](const Rational& at) { return plane({at, -1, -1}, {0, 9, 0}, {0, 0, 9}); };
  const RationalPatch upright_cylinder = cylinder(2, {0, 0, 0}, 1, 0, 2);
  const Point beside = {Rational(1, 4), Rational(1, 5), 0};
  const Point below = {0, Rational(1, 4), Rational(1, 8)};
  return {
      {"a circle on a cylinder", upright_cylinder, level, {0, 0, 0, 0}},
      {"a ruling of a cylinder", upright_cylinder, upright(h), {0, 0, 0, 0}},
      {"an ellipse whose height turns at an end", upright_cylinder, tilted, {0, 0, 0, 0}},
      // x + y turns halfway: v on the cylinder
      {"an ellipse whose height turns inside",
       upright_cylinder,
       plane({-1, -1, Rational(1, 4)}, {3, 0, Rational(3, 4)}, {0, 3, Rational(3, 4)}),
       {0, 1, 0, 0}},
      {"a ruling with irrational angles", upright_cylinder, upright(Rational(1, 3)), {0, 0, 0, 0}},
      {"two parallel cylinders",
       upright_cylinder,
       cylinder(2, {h, 0, -h}, Rational(3, 4), 0, 2),
       {0, 0, 0, 0}},
      {"crossing cylinders",
       cylinder(2, {0, 0, 0}, 1, -1, 1),
       cylinder(0, {0, Rational(1, 5), Rational(1, 7)}, h, -2, 2),
       {0, 0, 0, 0}},
      {"a parallel of a sphere", sphere(), level, {0, 0, 0, 0}},
      {"an upright circle on a sphere", sphere(), upright(h), {0, 0, 0, 0}},
      {"a cylinder through a sphere", sphere(), cylinder(2, beside, h, -1, 2), {0, 1, 0, 1}},
      {"a lying cylinder through a sphere",
       sphere(),
       cylinder(0, below, Rational(3, 8), -1, 2),
       {1, 0, 0, 1}},
      {"a parallel of a torus", torus(), level, {0, 0, 0, 0}},
      {"a curve on a torus", torus(), upright(1), {0, 0, 0, 0}},
      {"a parallel of a cone", cone(), level, {0, 0, 0, 0}},
      {"a hyperbola on a cone", cone(), upright(Rational(1, 4)), {0, 0, 0, 0}},
  };
}

/// Inner extrema of a parameter along the polylines of all arcs, one after another, beyond rounding.
int extrema(const IntersectionGraph& graph, std::size_t k) {
  int count = 0;
  for (const Component& component : graph.components) {
    std::vector<double> values;
    int at = -1;
    for (const int id : component.arcs) {
      const Arc& arc = graph.arcs[static_cast<std::size_t>(id)];
      std::vector<double> next;
      for (const PolylineVertex& v : arc.polyline) next.push_back(v.parameters[k]);
      const bool only = component.arcs.size() == 1;
      if (at < 0 && !only) {
        const Arc& second = graph.arcs[static_cast<std::size_t>(component.arcs[1])];
        at = arc.from == second.from || arc.from == second.to ? arc.to : arc.from;
      }
      if (!only && arc.from != at) std::reverse(next.begin(), next.end());
      at = arc.from == at ? arc.to : arc.from;
      values.insert(values.end(), next.begin(), next.end());
    }
    int direction = 0;
    double last = values.front();
    for (const double value : values) {
      if (std::fabs(value - last) < 1e-9) continue;
      const int sign = value > last ? 1 : -1;
      if (sign == -direction) ++count;
      direction = sign;
      last = value;
    }
  }
  return count;
}

std::array<double, 3> rounded(const Point& p) { return {to_double(p[0]), to_double(p[1]), to_double(p[2])}; }

void check_scene(const RationalPatch& x, const RationalPatch& y, const std::array<int, 4>& turning) {
  const IntersectResult result = intersect(x, y);
  REQUIRE(result.status == Status::complete);
  const IntersectionGraph& graph = result.graph;
  CHECK(graph.count(ComponentShape::open) == 1);
  CHECK(graph.components.size() == 1);
  CHECK(graph.boundary_points() == 2);
  for (std::size_t k = 0; k < 4; ++k) {
    INFO("parameter " << k);
    CHECK(graph.turning_points(all_parameters[k]) == turning[k]);
    CHECK(extrema(graph, k) == turning[k]);
  }
  for (const Arc& arc : graph.arcs) {
    for (std::size_t i = 0; i < arc.polyline.size(); i += 7) {
      const auto& [w, p] = arc.polyline[i];
      for (const auto& on : {rounded(x(from_double(w[0]), from_double(w[1]))),
                             rounded(y(from_double(w[2]), from_double(w[3])))})
        CHECK(std::hypot(p[0] - on[0], p[1] - on[1], p[2] - on[2]) <= 2 * arc.error_bound + 1e-12);
    }
  }
}

/// Rotated by a matrix of rational numbers, exactly, and moved.
RationalPatch rotated(const RationalPatch& x) {
  const std::array<Point, 3> rows = {{{Rational(2, 3), Rational(-1, 3), Rational(2, 3)},
                                      {Rational(2, 3), Rational(2, 3), Rational(-1, 3)},
                                      {Rational(-1, 3), Rational(2, 3), Rational(2, 3)}}};
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= x.degree_u(); ++i) {
    net.emplace_back();
    for (int j = 0; j <= x.degree_v(); ++j) {
      const HomogeneousPoint& p = x.homogeneous(i, j);
      const Point q = {p[0], p[1], p[2]};
      net.back().push_back({dot(rows[0], q) + 17 * p[3], dot(rows[1], q), dot(rows[2], q) - p[3], p[3]});
    }
  }
  return RationalPatch::from_homogeneous(net);
}

}  // namespace

TEST_CASE("round patches and planes along the axes, in both orders, rotated") {
  for (const Scene& scene : scenes()) {
    INFO(scene.name);
    const std::array<int, 4> other = {scene.turning[2], scene.turning[3], scene.turning[0], scene.turning[1]};
    check_scene(scene.x, scene.y, scene.turning);
    check_scene(scene.y, scene.x, other);
    check_scene(rotated(scene.x), rotated(scene.y), scene.turning);
    check_scene(scene.x.transposed(), scene.y,
                {scene.turning[1], scene.turning[0], scene.turning[2], scene.turning[3]});
  }
}

TEST_CASE("round patches: some turning points asked for are those of all") {
  for (const Scene& scene : scenes()) {
    for (std::size_t k = 0; k < 4; ++k) {
      INFO(scene.name << ", parameter " << k);
      IntersectOptions options;
      options.turning = {all_parameters[k]};
      const IntersectResult result = intersect(scene.x, scene.y, options);
      CHECK(result.status == Status::complete);
      for (std::size_t j = 0; j < 4; ++j)
        CHECK(result.graph.turning_points(all_parameters[j]) == (j == k ? scene.turning[j] : 0));
    }
  }
}

TEST_CASE("round patches: a curve, and a corner of the torus on the plane, in both orders") {
  const RationalPatch tilted = plane({-1, -1, 0}, {9, 0, 2}, {0, 9, 1});
  for (const bool exchanged : {false, true}) {
    const IntersectResult result = exchanged ? intersect(tilted, torus()) : intersect(torus(), tilted);
    CHECK(result.status == Status::complete);
    CHECK(result.graph.count(ComponentShape::open) == 1);
    REQUIRE(result.graph.isolated_points.size() == 1);
    const Node& node = result.graph.nodes[static_cast<std::size_t>(result.graph.isolated_points[0])];
    const std::size_t of_torus = exchanged ? 2 : 0;
    CHECK(node.box[of_torus].upper == 0);
    CHECK(node.box[of_torus + 1].lower == 1);
  }
}

TEST_CASE("round patches beside special position turn where they do") {
  // The height of the ellipse turns 1/1000 inside, or not at all.
  for (const int side : {-1, 0, 1}) {
    const Rational tilt(side, 1000);
    const RationalPatch tilted = plane({-1, -1, Rational(1, 4)}, {3, 0, Rational(3, 4)}, {0, 3, 3 * tilt});
    check_scene(cylinder(2, {0, 0, 0}, 1, 0, 2), tilted, {0, side > 0 ? 1 : 0, 0, 0});
  }
}

}  // namespace exsect::round_patches_test
