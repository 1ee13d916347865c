// What doubles decide of an equation on a patch, against the exact answer.
#include "filter/section_intersection.h"

#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <cmath>

#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"
#include "support/surface_moves.h"

namespace exsect::section_intersection_test {
namespace {

using S = ImplicitSurface;
using random_nets::Generator;

IntersectOptions options_of(bool exact, std::vector<Parameter> turning = {Parameter::u, Parameter::v}) {
  IntersectOptions options;
  options.exact = exact;
  options.turning = std::move(turning);
  return options;
}

bool is_in_doubles(const IntersectResult& result) { return result.work.steps.contains("filtered"); }

const RationalPatch& flat() {
  static const RationalPatch patch(
      std::vector<std::vector<Point>>{{{-1, -1, 0}, {-1, 1, 0}}, {{1, -1, 0}, {1, 1, 0}}});
  return patch;
}

/// Through the point, by turns of every kind.
S surface_through(const Point& p, int kind) {
  switch (kind) {
    case 0:
      return S::plane(p, {1, 3, 2});
    case 1:
      return S::cylinder(p, {1, 2, 2}, Rational(3, 10));
    case 2:
      return S::cone(p - Point{Rational(1, 2), 0, Rational(1, 3)}, {3, 1, 2}, Rational(1, 2));
    case 3:
      return S::cone(p - Point{Rational(1, 5), 0, Rational(1, 7)}, {3, 1, 2}, Rational(1, 2), 2);
    case 4:
      return S::sphere(p, Length::of_squared(Rational(1, 11)));
    case 5:
      return S::torus(p, {1, 2, 3}, Rational(3, 8), Rational(1, 8));
    default: {
      const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                            z = SpacePolynomial::variable(2);
      return S::polynomial(x * x * x - SpacePolynomial::constant(Rational(1, 3)) * y * z + y * y * z -
                           SpacePolynomial::constant(Rational(1, 5)));
    }
  }
}

/// Of a point from a polyline.
double distance(const std::array<double, 3>& p, const std::vector<PolylineVertex>& line) {
  double best = INFINITY;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    double along = 0, length = 0, squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double edge = line[i + 1].point[k] - line[i].point[k];
      along += edge * (p[k] - line[i].point[k]);
      length += edge * edge;
    }
    const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    for (std::size_t k = 0; k < 3; ++k)
      squared += std::pow(p[k] - line[i].point[k] - t * (line[i + 1].point[k] - line[i].point[k]), 2);
    best = std::min(best, squared);
  }
  return std::sqrt(best);
}

double distance_of_middle(const Arc& a, const Arc& b) {
  return distance(a.polyline[a.polyline.size() / 2].point, b.polyline);
}

/// The arc of the graph that runs through the middle of this one.
const Arc& same_arc(const Arc& arc, const IntersectionGraph& graph) {
  return *std::ranges::min_element(graph.arcs, {}, [&](const Arc& a) { return distance_of_middle(arc, a); });
}

/// The same graph with the same sides.
void check_same(const IntersectResult& found, const IntersectResult& exact) {
  REQUIRE(exact.status == Status::complete);
  CHECK(found.status == Status::complete);
  CHECK(difference(found.graph, exact.graph, {}) == "");
  REQUIRE(found.graph.arcs.size() == exact.graph.arcs.size());
  REQUIRE(found.graph.nodes.size() == exact.graph.nodes.size());
  for (const Arc& a : found.graph.arcs) {
    const Arc& b = same_arc(a, exact.graph);
    CHECK(a.polyline.front().parameters[0] <= a.polyline.back().parameters[0]);
    CHECK(a.place == b.place);
    CHECK(a.contact == b.contact);
    CHECK(a.beside == b.beside);
  }
}

}  // namespace

TEST_CASE("section intersection: random patches and surfaces of every kind have the exact graph") {
  constexpr std::uint64_t seed = 2208;
  INFO("seed " << seed);
  Generator generator(seed);
  int in_doubles = 0, all = 0;
  for (int round = 0; round < 63; ++round) {
    const int m = 1 + round % 3, n = 1 + round / 3 % 3;
    const random_nets::Net net = random_nets::doubles(generator, m, n);
    const RationalPatch patch =
        round % 2 == 0 ? RationalPatch(net) : random_nets::weighted_by_doubles(generator, net);
    const S surface = surface_through(patch(Rational(2, 5), Rational(1, 2)), round % 7);
    INFO("round " << round);
    for (const auto& turning : {std::vector{Parameter::u, Parameter::v}, std::vector<Parameter>{}}) {
      const IntersectResult found = intersect(surface, patch, options_of(false, turning));
      const IntersectResult exact = intersect(surface, patch, options_of(true, turning));
      CHECK_FALSE(is_in_doubles(exact));
      check_same(found, exact);
      ++all;
      if (is_in_doubles(found)) ++in_doubles;
    }
  }
  CHECK(in_doubles > all * 9 / 10);
}

TEST_CASE("section intersection: polylines keep within their bounds of each other") {
  constexpr std::uint64_t seed = 2209;
  INFO("seed " << seed);
  Generator generator(seed);
  for (int round = 0; round < 14; ++round) {
    const random_nets::Net net = random_nets::doubles(generator, 3, 2);
    const RationalPatch patch = round % 2 == 0 ? RationalPatch(net) : random_nets::weighted(generator, net);
    const S surface = surface_through(patch(Rational(2, 5), Rational(1, 2)), round % 7);
    IntersectOptions rough = options_of(false);
    rough.tolerance = 1e-3;
    const IntersectResult found = intersect(surface, patch, rough);
    const IntersectResult exact = intersect(surface, patch, options_of(true));
    if (!is_in_doubles(found)) continue;
    for (const Arc& a : found.graph.arcs) {
      const Arc& b = same_arc(a, exact.graph);
      CHECK(a.error_bound <= 1e-3);
      for (const PolylineVertex& v : a.polyline)
        CHECK(distance(v.point, b.polyline) <= a.error_bound + b.error_bound);
      for (const PolylineVertex& v : b.polyline)
        CHECK(distance(v.point, a.polyline) <= a.error_bound + b.error_bound);
    }
  }
}

TEST_CASE("section intersection: contact, corners, singular points and boxes are left to the exact answer") {
  const Run run;
  CHECK_FALSE(section_intersection(S::sphere({0, 0, 1}, 1), flat(), run));               // touches
  CHECK_FALSE(section_intersection(S::cylinder({0, 0, 1}, {1, 0, 0}, 1), flat(), run));  // along a line
  CHECK_FALSE(section_intersection(S::plane({0, 0, 0}, {0, 0, 1}), flat(), run));        // all of it
  CHECK_FALSE(section_intersection(S::plane({0, 0, 0}, {1, 1, 1}), flat(), run));        // through corners
  CHECK_FALSE(section_intersection(S::cone({0, 0, 0}, {1, 0, 0}, 1), flat(), run));      // apex
  CHECK_FALSE(section_intersection(S::cone({0, 0, 0}, {0, 0, 1}, 1), flat(), run));      // apex alone
  CHECK_FALSE(section_intersection(S::cylinder({0, 1, 0}, {0, 0, 1}, 1), flat(), run));  // touches a side
  SpacePolynomial square = SpacePolynomial::variable(0) - SpacePolynomial::constant(Rational(1, 3));
  square = square * square;
  CHECK_FALSE(section_intersection(S::polynomial(square), flat(), run));
  CHECK(section_intersection(S::cylinder({0, 0, 0}, {0, 0, 1}, Rational(1, 2)), flat(), run));
  const S whole = S::sphere({0, 0, 0}, Rational(1, 2));
  CHECK(section_intersection(whole, flat(), run));
  SurfaceRegion half;
  half.bounds.push_back({"half", SpacePolynomial::variable(0), SpacePolynomial::constant(1)});
  half.clauses = {{0}};
  CHECK_FALSE(section_intersection(whole.part_in(half), flat(), run));
}

TEST_CASE("section intersection: of a cone of one nappe, the curves on it") {
  // On the plane x = 0 both nappes of the cone about z with the apex (1/4, 0, 0) leave a branch of a
  // hyperbola.
  const RationalPatch upright(
      std::vector<std::vector<Point>>{{{0, -1, -1}, {0, -1, 2}}, {{0, 1, -1}, {0, 1, 2}}});
  const Point apex = {Rational(1, 4), 0, 0};
  const Run run;
  const auto both = section_intersection(S::cone(apex, {0, 0, 1}, 1, 2), upright, run);
  const auto upper = section_intersection(S::cone(apex, {0, 0, 1}, 1), upright, run);
  const auto lower = section_intersection(S::cone(apex, {0, 0, -1}, 1), upright, run);
  REQUIRE((both && upper && lower));
  CHECK(both->graph.components.size() == 2);
  CHECK(upper->graph.components.size() == 1);
  CHECK(lower->graph.components.size() == 1);
  for (const Node& node : upper->graph.nodes) CHECK(node.point[2] > 0);
  for (const Node& node : lower->graph.nodes) CHECK(node.point[2] < 0);
}

TEST_CASE("section intersection: near misses are decided rightly or not at all") {
  Rational off = 1;
  for (int k = 1; k <= 20; ++k) {
    off /= 10;
    INFO("10^-" << k);
    for (const int sign : {-1, 1}) {
      const S ball = S::sphere({Rational(1, 7), Rational(1, 9), 1 + sign * off}, 1);
      const auto found = section_intersection(ball, flat(), Run(options_of(false)));
      if (found) CHECK(found->graph.arcs.size() == (sign < 0 ? 4 : 0));
      if (k <= 10) CHECK(found);
      // Beside a side, beside a corner, two curves beside each other.
      const S beside = S::cylinder({0, 0, 0}, {0, 0, 1}, 1 + sign * off);
      const auto circle = section_intersection(beside, flat(), Run(options_of(false)));
      if (circle) CHECK(circle->graph.boundary_points() == (sign < 0 ? 0 : 8));
      const S corner = S::plane({1 + sign * off, 1, 0}, {1, 2, 0});
      const auto line = section_intersection(corner, flat(), Run(options_of(false)));
      if (line) CHECK(line->graph.boundary_points() == (sign < 0 ? 2 : 0));
      const S cone = S::cone({0, Rational(1, 9), sign * off}, {2, 1, 0}, Rational(1, 2), 2);
      const auto hyperbola = section_intersection(cone, flat(), Run(options_of(false)));
      if (hyperbola) CHECK(hyperbola->graph.components.size() == 2);
    }
  }
}

TEST_CASE("section intersection: rotated, times 25.4 and at 1e8, with u and v exchanged") {
  constexpr std::uint64_t seed = 2210;
  INFO("seed " << seed);
  Generator generator(seed);
  for (int round = 0; round < 7; ++round) {
    const random_nets::Net net = random_nets::doubles(generator, 2, 3);
    const RationalPatch patch(net);
    const S surface = surface_through(patch(Rational(2, 5), Rational(1, 2)), round);
    const IntersectResult here = intersect(surface, patch, options_of(false));
    const IntersectResult exchanged = intersect(surface, patch.transposed(), options_of(false));
    CHECK(difference(here.graph, exchanged.graph, {{1, 0, 2, 3}, {}}) == "");
    if (round == 6) continue;
    for (const auto& [name, motion] : surface_moves::motions()) {
      INFO(name);
      random_nets::Net moved = net;
      for (auto& row : moved)
        for (Point& p : row) p = motion(p);
      const IntersectResult there = intersect(motion(surface), RationalPatch(moved), options_of(false));
      CHECK(there.status == Status::complete);
      CHECK(difference(here.graph, there.graph, {}) == "");
    }
  }
}

TEST_CASE("section intersection: vertices are in the square beside a side, too") {
  // v = g(u), cubic, crosses the side v = 0 and is never farther than 9e-6 from it.
  const std::array<int, 4> heights = {9, -8, 6, -2};
  random_nets::Net net;
  for (int i = 0; i < 4; ++i) {
    net.emplace_back();
    for (const int v : {0, 1})
      net.back().push_back({Rational(i, 3), v, v - Rational(heights[static_cast<std::size_t>(i)], 1000000)});
  }
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-6}) {
    INFO("tolerance " << tolerance);
    IntersectOptions options = options_of(false, {});
    options.tolerance = tolerance;
    const IntersectResult result = intersect(S::plane({0, 0, 0}, {0, 0, 1}), RationalPatch(net), options);
    REQUIRE(result.status == Status::complete);
    CHECK(is_in_doubles(result));
    for (const Arc& arc : result.graph.arcs) {
      CHECK(arc.error_bound <= tolerance);
      for (const PolylineVertex& vertex : arc.polyline)
        for (const double w : {vertex.parameters[0], vertex.parameters[1]}) {
          CHECK(w >= 0);
          CHECK(w <= 1);
        }
    }
  }
}

}  // namespace exsect::section_intersection_test
