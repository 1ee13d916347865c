// Pairs decided by the inverse of one patch: against doubles, and by what is known of their curves.
#include "special/intersect_by_inverse.h"

#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <functional>

#include "filter/filter.h"
#include "solver/special/revolved.h"
#include "support/catch.h"
#include "support/chain_checks.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace exsect::intersect_by_inverse_test {
namespace {

using random_nets::Generator;

/// A part of the torus about the z axis with radii 3 and 1, about the circle nearest to z = 1.
RationalPatch torus_from_above() {
  const revolved::Arc3 arc = revolved::arc(Rational(-2, 3), Rational(2, 3));
  revolved::Arc3 profile;
  for (const auto& [c, s, w] : arc) profile.push_back({3 * w + s, c, w});
  return revolved::patch(profile, arc);
}

/// To both sides of y = 0: the torus, outside or inside, and a sphere about a point of the plane z = 0 with
/// another axis, up to its pole.
RationalPatch torus(int side) {
  const revolved::Arc3 arc = revolved::arc(Rational(-1, 2), Rational(1, 2));
  return revolved::patch(revolved::moved(arc, side, 3), arc);
}
RationalPatch tilted_sphere(const Rational& radius, const Rational& x) {
  const revolved::Arc3 profile = revolved::moved(revolved::arc(Rational(-1, 2), 1), radius, 0);
  const RationalPatch sphere = revolved::patch(profile, revolved::arc(Rational(-1, 2), Rational(2, 3)));
  return revolved::rotated(sphere, {7, 1, 1, 0}, {x, 0, 0});
}

/// Around z = height, a parallelogram.
RationalPatch plate(const Rational& height) {
  return RationalPatch({{{-1, -8, height}, {0, 5, height}}, {{6, -4, height}, {7, 9, height}}});
}

std::optional<IntersectResult> by_inverse(const RationalPatch& x, const RationalPatch& y,
                                          const Run& run = Run()) {
  const auto of_y = patch_inverse(y);
  REQUIRE(of_y);
  const auto curve = curve_by_inverse(x, y, *of_y, run);
  return curve ? intersect_by_inverse(curve, run) : std::nullopt;
}

IntersectResult solved(const RationalPatch& x, const RationalPatch& y) {
  const auto result = by_inverse(x, y);
  REQUIRE(result);
  REQUIRE(result->status == Status::complete);
  return *result;
}

IntersectionGraph solved_without_turnings(const RationalPatch& x, const RationalPatch& y) {
  const auto result = by_inverse(x, y, Run().with_turning({}));
  REQUIRE(result);
  REQUIRE(result->status == Status::complete);
  return result->graph;
}

/// A patch with the point at the place, and its surface; all of the surface within some 2 of it is patch.
struct Touching {
  RationalPatch patch;
  ImplicitSurface surface;
  std::array<Rational, 2> at;
};

/// A plane, a cylinder, a sphere or a torus with the normal (1,0,0), turned.
Touching touching(int kind, const std::array<int, 4>& turn, const Point& point) {
  const revolved::Arc3 wide = revolved::arc(Rational(-3, 4), Rational(3, 4));
  const Rational radius = kind == 3 ? 2 : 4, major = kind == 3 ? 6 : 0, half(1, 2);
  const revolved::Arc3 line = {{radius, -3, 1}, {radius, 3, 1}};
  const RationalPatch patch = kind == 0 ? RationalPatch({{{0, -3, -3}, {0, -3, 3}}, {{0, 3, -3}, {0, 3, 3}}})
                              : kind == 1 ? revolved::patch(line, wide)
                                          : revolved::patch(revolved::moved(wide, radius, major), wide);
  const Point out = {kind == 0 ? Rational(0) : radius + major, 0, 0};
  const RationalPatch frame =
      revolved::rotated(RationalPatch({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, out}}), turn, {0, 0, 0});
  const Point normal = frame(0, 1), axis = frame(1, 0), centre = point - frame(1, 1);
  const RationalPatch placed = revolved::rotated(patch, turn, centre);
  switch (kind) {
    case 0:
      return {placed, ImplicitSurface::plane(point, normal), {half, half}};
    case 1:
      return {placed, ImplicitSurface::cylinder(centre, axis, radius), {half, half}};
    case 2:
      return {placed, ImplicitSurface::sphere(centre, radius), {half, half}};
    default:
      return {placed, ImplicitSurface::torus(centre, axis, major, radius), {half, half}};
  }
}

/// Near the points of the other patch of random_nets::crossing().
std::vector<std::function<RationalPatch(Generator&)>> makers() {
  const auto middle = [](Generator& generator) {
    const RationalPatch y = random_nets::crossing(generator, {1, 1, 1, 1}, false).second();
    return std::array{y(0, 0), y(0, 1), y(1, 0)};
  };
  return {[](Generator& generator) {
            return random_nets::crossing(generator, {2, 2, 1, 1}, true).second();
          },
          [middle](Generator& generator) {
            const auto [a, b, c] = middle(generator);
            return RationalPatch({{a, b}, {c, b + c - a}});
          },
          [middle](Generator& generator) {
            const auto [a, b, c] = middle(generator);
            return random_nets::reparametrised(
                RationalPatch({{a, b}, {c, c + Rational(2, 3) * (b - a)}}).transposed(), Rational(3, 5));
          },
          [middle](Generator& generator) {  // a cone or a cylinder over a parabola
            const auto [a, b, c] = middle(generator);
            const Point up = Rational(1, 5) * cross(b - a, c - a);
            const Rational scale(generator() % 2 == 0 ? 1 : 2, 2);
            std::vector<std::vector<Point>> net;
            for (const int i : {0, 1, 2}) {
              const Point p = a + Rational(i, 2) * (c - a) + (i == 1 ? up : Point{0, 0, 0});
              net.push_back({p, a + scale * (p - a) + (b - a)});
            }
            return RationalPatch(net);
          }};
}

}  // namespace

TEST_CASE("by inverse: the graph that doubles find") {
  int compared = 0, arcs = 0;
  for (std::size_t kind = 0; kind < makers().size(); ++kind)
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      INFO("kind " << kind << ", seed " << seed);
      Generator generator(seed);
      const RationalPatch y = makers()[kind](generator);
      const random_nets::Net net = random_nets::crossing(generator, {2, 2, 1, 1}, seed % 2 == 0).x;
      const RationalPatch x = seed % 3 == 0 ? RationalPatch(net) : random_nets::weighted(generator, net);
      const IntersectResult in_doubles = intersect_in_doubles(x, y, Run());
      if (in_doubles.status != Status::complete) continue;
      const IntersectResult result = solved(x, y);
      CHECK(difference(result.graph, in_doubles.graph, {}) == "");
      ++compared;
      arcs += static_cast<int>(result.graph.arcs.size());
    }
  CHECK(compared >= 20);
  CHECK(arcs >= 20);
}

TEST_CASE("by inverse: bicubic patches on planes, with and without turning points") {
  for (const bool all : {true, false}) {
    Generator generator(7);
    const RationalPatch y = makers()[1](generator);
    const RationalPatch x =
        random_nets::weighted(generator, random_nets::crossing(generator, {3, 3, 1, 1}, true).x);
    IntersectOptions options;
    if (!all) options.turning = {};
    const Run run(options);
    const auto result = by_inverse(x, y, run);
    REQUIRE(result);
    CHECK(difference(result->graph, intersect_in_doubles(x, y, run).graph, {}) == "");
  }
}

// The plane touches the circle s = 0 in the middle of the arc and of the rectangle: s and v turn there.
TEST_CASE("by inverse: a turning point on a side is a boundary point alone") {
  const RationalPatch rectangle({{{6, -10, 8}, {-6, -10, -8}}, {{6, 10, 8}, {-6, 10, -8}}});
  const RationalPatch cone(
      {{{-2, 4, 0}, {4, 12, -20}}, {{2, 1, 0}, {16, 3, -20}}, {{-1, -3, 0}, {7, -9, -20}}},
      {{1, 1}, {1, 1}, {2, 2}});
  for (const RationalPatch& x : {rectangle, rectangle.transposed()}) {
    const IntersectionGraph graph = solved(x, cone).graph;
    REQUIRE(graph.nodes.size() == 3);
    for (const Node& node : graph.nodes) {
      CHECK(node.kinds == std::vector{NodeKind::boundary});
      CHECK(node.wrt.empty());
    }
  }
}

TEST_CASE("by inverse: nothing is said of curves of high degree") {
  Generator generator(7);
  CHECK_FALSE(by_inverse(random_nets::crossing(generator, {3, 3, 1, 1}, true).first(), torus_from_above()));
}

TEST_CASE("by inverse: a torus lies on a plate") {
  const IntersectResult contact = solved(torus_from_above(), plate(1));
  CHECK(contact.graph.count(ComponentShape::open) == 1);
  for (const Arc& arc : contact.graph.arcs) CHECK(arc.contact == Contact::tangential);
  // The circle turns in r and in s, as the plate's sides are oblique, and nowhere in u and v.
  CHECK(contact.graph.turning_points(Parameter::u) == 0);
  CHECK(contact.graph.turning_points(Parameter::v) == 0);
  CHECK(contact.graph.turning_points(Parameter::r) == 1);
  CHECK(contact.graph.turning_points(Parameter::s) == 1);
  for (const int digits : {3, 6, 12, 20}) {
    const Rational e = 1 / Rational(pow(Integer(10), static_cast<unsigned>(digits)));
    CHECK(solved(torus_from_above(), plate(1 + e)).graph.nodes.empty());
    const IntersectResult crossing = solved(torus_from_above(), plate(1 - e));
    CHECK(crossing.graph.count(ComponentShape::open) == 2);
    for (const Arc& arc : crossing.graph.arcs) CHECK(arc.contact == Contact::transversal);
  }
}

TEST_CASE("by inverse: sides that cut a curve of contact, or leave a point of it") {
  const Rational h(1);
  const auto plate_from = [&](const Rational& x, const Rational& y, const Rational& to) {
    return RationalPatch({{{x, y, h}, {x, 6, h}}, {{to, y, h}, {to, 6, h}}});
  };
  const IntersectResult cut = solved(torus_from_above(), plate_from(0, 0, 6));
  CHECK(cut.graph.arcs.size() == 1);
  CHECK(cut.graph.boundary_points() == 2);
  for (const Rational& y : {Rational(-6), Rational(0)}) {
    const IntersectResult point = solved(torus_from_above(), plate_from(3, y, 6));
    CHECK(point.graph.arcs.empty());
    REQUIRE(point.graph.isolated_points.size() == 1);
    const std::vector<NodeKind>& kinds = point.graph.nodes[0].kinds;
    CHECK(std::ranges::count(kinds, NodeKind::touch) == 1);
    CHECK(std::ranges::count(kinds, NodeKind::corner) == (y == 0 ? 1 : 0));
  }
  const IntersectResult inside = solved(torus_from_above(), plate_from(0, -6, 3));
  CHECK(inside.graph.arcs.size() == 2);
  CHECK(inside.graph.boundary_points() == 3);
  CHECK(inside.graph.count(ComponentShape::open) == 1);
}

TEST_CASE("by inverse: spheres that touch tori along circles, and nearly") {
  struct Touching {
    const char* name;
    RationalPatch x;
    Rational radius;
    Rational centre;
    bool from_outside;
  };
  for (const auto& [name, x, radius, centre, from_outside] :
       {Touching{"in the tube", torus(1), 1, 3, false}, Touching{"in the hole", torus(-1), 2, 0, false},
        Touching{"around the torus", torus(1), 4, 0, true}}) {
    INFO(name);
    const RationalPatch y = tilted_sphere(radius, centre);
    for (const IntersectResult& contact : {solved(x, y), solved(y, x)}) {
      CHECK(contact.graph.count(ComponentShape::open) == 1);
      for (const Arc& arc : contact.graph.arcs) CHECK(arc.contact == Contact::tangential);
      CHECK(contact.graph.boundary_points() == 2);
    }
    for (const int digits : {3, 6, 12, 20})
      for (const int sign : {1, -1}) {
        INFO(digits << " digits, sign " << sign);
        const Rational e = sign / Rational(pow(Integer(10), static_cast<unsigned>(digits)));
        const IntersectResult near = solved(x, tilted_sphere(radius + e, centre));
        CHECK(near.graph.arcs.empty() == ((sign > 0) == from_outside));
        for (const Arc& arc : near.graph.arcs) CHECK(arc.contact == Contact::transversal);
      }
  }
}

TEST_CASE("by inverse: spheres and tori in general position as doubles find them") {
  Generator generator(11);
  const auto number = [&] { return Rational(static_cast<int>(generator() % 33) - 16, 20); };
  int compared = 0, arcs = 0;
  for (int i = 0; i < 8; ++i) {
    INFO("pair " << i);
    const RationalPatch x = i % 2 == 0 ? torus(1) : tilted_sphere(2, 2);
    const RationalPatch y =
        revolved::rotated(i < 4 ? torus(1) : tilted_sphere(Rational(7, 2), 0),
                          {9, static_cast<int>(generator() % 5), static_cast<int>(generator() % 5), 1},
                          {number(), number(), 0});
    const IntersectResult in_doubles = intersect_in_doubles(x, y, Run());
    if (in_doubles.status != Status::complete) continue;
    const auto result = by_inverse(x, y);
    if (!result) continue;
    CHECK(difference(result->graph, in_doubles.graph, {}) == "");
    ++compared;
    arcs += static_cast<int>(result->graph.arcs.size());
  }
  CHECK(compared >= 5);
  CHECK(arcs >= 5);
}

TEST_CASE("by inverse: a curve that goes through a pole of the patch with the inverse") {
  const revolved::Arc3 quarter = {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}};
  const RationalPatch y = revolved::patch(quarter, quarter);
  const auto plane = [](const Rational& slope) {
    return RationalPatch(
        {{{-1, -2, 1 + slope}, {-1, 2, 1 + slope}}, {{3, -2, 1 - 3 * slope}, {3, 2, 1 - 3 * slope}}});
  };
  for (const Rational& slope : {Rational(1, 2), Rational(0)}) {
    const IntersectionGraph graph = solved(plane(slope), y).graph;
    CHECK(graph.arcs.size() == (slope == 0 ? 0 : 2));  // along the side s = 0, and through it
    CHECK(std::ranges::count_if(graph.nodes, [](const Node& node) {
            return node.free == std::vector{Parameter::s} && node.box[2].lower == 1;
          }) == 1);
  }
  CHECK(solved(plane(-Rational(1, 2)).restricted_to(Rational(3, 8), 1, 0, 1), y).graph.arcs.empty());
}

TEST_CASE("by inverse: nothing is said where a part of the curve is one point of a patch inside") {
  const auto rows = [](const Rational& height) -> std::vector<std::vector<Point>> {
    return {{{0, 0, height}, {0, 3, height}}, {{0, 0, 0}, {0, -3, 0}}, {{3, 0, -height}, {3, 3, -height}}};
  };
  // The line u = 1/2 of the second one is the point (3/4,0,0).
  CHECK(by_inverse(RationalPatch({rows(2)[0], {{0, 0, 0}, {0, -2, 0}}, rows(2)[2]}), plate(0)));
  CHECK_FALSE(by_inverse(RationalPatch(rows(2)), plate(0)));
}

TEST_CASE("by inverse: arcs end in a pole as they end on its side by the equation") {
  // Octants and a cone, of which the side u = 1 is their pole, on surfaces through it with all normals.
  const revolved::Arc3 quarter = {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}};
  const revolved::Arc3 line = {{Rational(3, 4), 0, 1}, {0, 1, 1}};
  const std::vector<RationalPatch> with_pole = {revolved::patch(quarter, quarter),
                                                revolved::patch(line, quarter)};
  const std::vector<std::array<int, 4>> turns = {{1, 0, 0, 0},  {1, 0, 1, 0},  {1, 0, -1, 0}, {1, 0, 0, 1},
                                                 {1, 0, 0, -1}, {1, 1, 1, 1},  {0, 0, 0, 1},  {1, 1, 0, 0},
                                                 {2, 0, -1, 0}, {1, 1, -1, 1}, {3, 1, 0, 0},  {2, 0, 0, 1},
                                                 {5, 1, 2, 1},  {1, -1, 1, 1}, {3, 0, -1, 0}};
  int arcs = 0, alone = 0, tangential = 0, along_sides = 0, both_ways = 0;
  for (const int kind : {0, 1, 2, 3})
    for (const std::array<int, 4>& turn : turns)
      for (const RationalPatch& x : with_pole) {
        INFO("kind " << kind << ", turn " << turn[0] << turn[1] << turn[2] << turn[3]);
        const Touching y = touching(kind, turn, {0, 0, 1});
        const IntersectionGraph graph = solved_without_turnings(x, y.patch);
        const IntersectionGraph all = intersect(y.surface, x).graph;
        const Side pole = {Parameter::u, 1};
        const auto is_in_pole = [&](const Node& node) { return std::ranges::count(node.on, pole) > 0; };
        const auto starts_in_pole = [&](int id) {
          return is_in_pole(all.nodes[static_cast<std::size_t>(id)]);
        };
        const auto is_beside = [&](const Arc& arc) {
          return !starts_in_pole(arc.from) || !starts_in_pole(arc.to);
        };
        CHECK(graph.arcs.size() == static_cast<std::size_t>(std::ranges::count_if(all.arcs, is_beside)));
        REQUIRE(std::ranges::count_if(graph.nodes, is_in_pole) == 1);
        const Node& node = *std::ranges::find_if(graph.nodes, is_in_pole);
        CHECK(node.free == std::vector{Parameter::v});
        CHECK(node.point == std::array<double, 3>{0, 0, 1});
        CHECK(node.box[2].lower <= y.at[0]);
        CHECK(node.box[2].upper >= y.at[0]);
        CHECK(node.box[3].lower <= y.at[1]);
        CHECK(node.box[3].upper >= y.at[1]);
        const auto at_pole = [&](const Arc& arc) { return arc.from == node.id || arc.to == node.id; };
        const auto ends = std::ranges::count_if(graph.arcs, at_pole);
        CHECK(std::ranges::count(graph.isolated_points, node.id) == (ends == 0 ? 1 : 0));
        arcs += static_cast<int>(ends);
        alone += ends == 0 ? 1 : 0;
        for (const Arc& arc : graph.arcs) {
          tangential += arc.contact == Contact::tangential && at_pole(arc) ? 1 : 0;
          along_sides += arc.place == ArcPlace::patch_boundary && at_pole(arc) ? 1 : 0;
        }
        const auto exchanged = by_inverse(y.patch, x, Run().with_turning({}));
        // Where it touches a ruling in an apex the parameter changes too fast for polylines to tell it.
        const bool is_told = turn != turns.back() || kind < 2;
        if (exchanged && is_told) CHECK(difference(graph, exchanged->graph, {{2, 3, 0, 1}, {}}) == "");
        both_ways += exchanged ? 1 : 0;
        const auto turned = by_inverse(x.restricted_to(1, 0, 1, 0), y.patch, Run().with_turning({}));
        REQUIRE(turned);
        CHECK(difference(graph, turned->graph, {{0, 1, 2, 3}, {true, true}}) == "");
      }
  CHECK(arcs >= 30);
  CHECK(alone >= 20);
  CHECK(tangential >= 1);
  CHECK(along_sides >= 10);
  CHECK(both_ways >= 80);
}

TEST_CASE("by inverse: Viviani's curve ends in the pole, along the end of its side") {
  const revolved::Arc3 quarter = {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}};
  const RationalPatch x = revolved::patch(revolved::moved(quarter, 1, 0), quarter);
  const Rational half(1, 2);
  const revolved::Arc3 upright = {{half, -2, 1}, {half, 2, 1}};
  const auto cylinder = [&](const Rational& off) {  // its quarter above 0 <= x <= 1/2
    return revolved::rotated(revolved::patch(upright, quarter), {1, 0, 0, 1}, {half + off, 0, 0});
  };
  const IntersectionGraph graph = solved(x, cylinder(0)).graph;
  CHECK(graph.arcs.size() == 1);
  REQUIRE(graph.nodes.size() == 2);
  CHECK(std::ranges::count_if(graph.nodes, [](const Node& node) {
          return node.free == std::vector{Parameter::v} && node.box[0].lower == 1;
        }) == 1);
  // Beside the pole the curve leaves by the side v = 1, or there is none of it near.
  for (const long bits : {10, 40, 66})
    for (const int sign : {1, -1}) {
      INFO("off by " << sign << " 2^-" << bits);
      const IntersectResult near = intersect(x, cylinder(sign * power_of_two(-bits)));
      CHECK(near.status == Status::complete);
      CHECK(std::ranges::all_of(near.graph.nodes, [](const Node& node) { return node.free.empty(); }));
      CHECK(near.graph.components.size() == 1);
    }
}

TEST_CASE("by inverse: overlaps in a plane as they are found by the maps of the plane") {
  Generator generator(5);
  const auto digit = [&](int most) {
    return Rational(static_cast<int>(generator() % static_cast<unsigned>(2 * most + 1)) - most, 2);
  };
  int overlaps = 0;
  for (int round = 0; round < 4; ++round) {
    INFO("round " << round);
    const auto corner = [&](int x, int y) { return Point{x + digit(3), y + digit(3), 0}; };
    const RationalPatch x({{corner(0, 0), corner(0, 8)}, {corner(8, 0), corner(8, 8)}});
    const Point a = corner(3, 2), b = corner(5, 0), c = corner(0, 5);
    const RationalPatch y({{a, a + b}, {a + c, a + b + c}});
    const IntersectResult by_maps = intersect(*x.biquadratic(), *y.biquadratic());
    REQUIRE(by_maps.status == Status::complete);
    CHECK(difference(solved(x, y).graph, by_maps.graph, {}) == "");
    overlaps += static_cast<int>(by_maps.graph.overlaps.size());
  }
  CHECK(overlaps >= 3);
}

TEST_CASE("by inverse: plates with a side, a part of a side or a corner in common") {
  const auto cell = [](const Rational& x0, const Rational& y0, const Rational& x1, const Rational& y1) {
    return RationalPatch({{{x0, y0, 0}, {x0, y1, 0}}, {{x1, y0, 0}, {x1, y1, 0}}}, {{1, 2}, {3, 6}});
  };
  const RationalPatch x = cell(0, 0, 2, 2);
  for (const auto& [from, to] : {std::pair{0, 2}, std::pair{1, 3}, std::pair{-1, 1}}) {
    const IntersectionGraph graph = solved(x, cell(2, from, 3, to)).graph;
    CHECK(graph.overlaps.empty());
    REQUIRE(graph.arcs.size() == 1);
    CHECK(graph.arcs[0].place == ArcPlace::patch_boundary);
    CHECK(graph.arcs[0].contact == Contact::tangential);
    CHECK(graph.nodes.size() == 2);
  }
  const IntersectionGraph corner = solved(x, cell(2, 2, 3, 3)).graph;
  CHECK(corner.overlaps.empty());
  CHECK(corner.arcs.empty());
  REQUIRE(corner.isolated_points.size() == 1);
  CHECK(corner.nodes[0].kinds == std::vector{NodeKind::boundary, NodeKind::corner, NodeKind::touch});
  CHECK(solved(x, cell(3, 2, 4, 3)).graph.nodes.empty());
}

/// On the cylinder of radius 2 about the axis of z. Coefficients of x/2, y/2 and 1 give heights for v = 0 and
/// 1, and the middle control points, of weights 3/2 times as great, of three.
RationalPatch on_cylinder(const revolved::Arc3& arc, const std::vector<Point>& heights) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const auto& [x, y, w] : arc) {
    net.emplace_back();
    for (const Point& h : heights) {
      const Rational scale = net.back().size() == 1 && heights.size() > 2 ? Rational(3, 2) : Rational(1);
      net.back().push_back(
          {scale * 2 * x, scale * 2 * y, scale * (h[0] * x + h[1] * y + h[2] * w), scale * w});
    }
  }
  return RationalPatch::from_homogeneous(net);
}

TEST_CASE("by inverse: an overlap on a cylinder whose parameters no Moebius maps relate") {
  const RationalPatch x =
      on_cylinder(revolved::arc(Rational(-1, 3), Rational(3, 4)),
                  {{0, Rational(1, 5), -1}, {Rational(1, 9), 0, 0}, {0, Rational(1, 2), 2}});
  const auto y = [](const Rational& off) {
    return on_cylinder(revolved::arc(Rational(-1, 2), Rational(1, 2)),
                       {{off, Rational(1, 3), -1}, {off, 0, Rational(3, 2)}});
  };
  const IntersectionGraph graph = solved(x, y(0)).graph;
  REQUIRE(graph.overlaps.size() == 1);
  REQUIRE(graph.overlaps[0].chains.size() == 1);
  CHECK(graph.arcs.empty());
  int covered = 0;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) {
      const Rational u(2 * i + 1, 20), v(2 * j + 1, 20);
      INFO("u " << u << ", v " << v);
      const HomogeneousPoint p = x.homogeneous_at(u, v);
      const bool expected = 4 * p[0] >= 3 * abs(p[1]) && 6 * p[2] >= p[1] - 6 * p[3] && 2 * p[2] <= 3 * p[3];
      CHECK(inside(graph.overlaps[0].chains[0], to_double(u), to_double(v)) == expected);
      covered += expected ? 1 : 0;
    }
  CHECK(covered > 10);
  CHECK(covered < 90);
  const RationalPatch moved = revolved::rotated(y(0), {1, 0, 0, 0}, {power_of_two(-66), 0, 0});
  CHECK(solved(x, moved).graph.overlaps.empty());
}

TEST_CASE("by inverse: without an overlap a side that is one point is one node") {
  // The side u = 1 is the corner (0,2) of the triangle.
  const RationalPatch triangle({{{0, 0, 0}, {2, 0, 0}}, {{0, 2, 0}, {0, 2, 0}}});
  const auto square = [](const Rational& x, const Rational& y, const Rational& z) {
    return RationalPatch({{{x, y, z}, {x, y + 2, z}}, {{x + 2, y, z}, {x + 2, y + 2, z}}});
  };
  // In the corner alone; along the side v = 0 to it, and beyond.
  for (const auto& [y, arcs] : {std::pair{square(0, 2, 0), std::size_t{0}},
                                {square(-2, 2, 0), 0},
                                {square(-1, 2, 0), 0},
                                {square(-2, 0, 0), 1},
                                {square(-2, 1, 0), 1}}) {
    const IntersectionGraph graph = solved(triangle, y).graph;
    CHECK(graph.overlaps.empty());
    CHECK(graph.arcs.size() == arcs);
    CHECK(graph.isolated_points.size() == 1 - arcs);
    REQUIRE(graph.nodes.size() == 1 + arcs);
    const auto pole = std::ranges::find_if(graph.nodes, [](const Node& node) { return !node.free.empty(); });
    REQUIRE(pole != graph.nodes.end());
    CHECK(pole->free == std::vector{Parameter::v});
    CHECK(pole->box[1].lower == 0);
    CHECK(pole->box[1].upper == 1);
    CHECK(pole->on.front() == Side{Parameter::u, 1});
    CHECK(std::ranges::count(pole->on, Parameter::v, &Side::parameter) == 0);
    const IntersectionGraph turned = solved(triangle.transposed().restricted_to(0, 1, 1, 0), y).graph;
    CHECK(difference(graph, turned, {{1, 0, 2, 3}, {true}}) == "");
  }
  for (const long bits : {10, 40, 66}) {
    const Rational off = power_of_two(-bits);
    CHECK(solved(triangle, square(0, 2 + off, 0)).graph.nodes.empty());
    CHECK(solved(triangle, square(-2, 0, off)).graph.nodes.empty());
    CHECK(solved(triangle, square(0, 2 - off, 0)).graph.overlaps.size() == 1);
  }
}

TEST_CASE(
    "by inverse: an octant and a zone of one sphere, with a quarter of the equator to the pole in common") {
  const Rational a(3, 2), b(3, 4), c(9, 10), d(6, 5);
  const RationalPatch x({{{a, 0, 0}, {a, -a, 0}, {0, -a, 0}},
                         {{a, 0, a}, {a, -a, a}, {0, -a, 0}},
                         {{0, 0, a}, {0, -a, a}, {0, -a, 0}}},
                        {{2, 2, 4}, {2, 2, 4}, {4, 4, 8}});
  const RationalPatch y({{{a, 0, 0}, {a, 0, -b}, {c, 0, -d}},
                         {{a, -a, 0}, {a, -a, -b}, {c, -c, -d}},
                         {{0, -a, 0}, {0, -a, -b}, {0, -c, -d}}},
                        {{1, 1, Rational(5, 4)}, {1, 1, Rational(5, 4)}, {2, 2, Rational(5, 2)}});
  const IntersectResult quick = intersect_in_doubles(x, y, Run());
  REQUIRE(quick.status == Status::complete);
  CHECK(difference(solved(x, y).graph, quick.graph, {}) == "");
}

TEST_CASE("by inverse: a pole inside of the other patch is a side of the overlap") {
  const RationalPatch triangle({{{0, 0, 0}, {2, 0, 0}}, {{0, 2, 0}, {0, 2, 0}}});
  const auto square = [](int x, int y) {
    return RationalPatch({{{x, y, 0}, {x, y + 2, 0}}, {{x + 2, y, 0}, {x + 2, y + 2, 0}}});
  };
  const IntersectionGraph inside = solved(square(-1, 1), triangle).graph;
  CHECK(inside.overlaps.size() == 1);
  CHECK(difference(inside, solved(triangle, square(-1, 1)).graph, {{2, 3, 0, 1}, {}}) == "");
  CHECK(solved(square(-1, -1), triangle).graph.overlaps.size() == 1);
}

TEST_CASE("by inverse: a pole of the patch with the inverse that is a corner of it too is left to others") {
  // y = m (1, s, r) for m = s (1 + gap - s + r): 0 on the side s = 0, and, without a gap, in the corner
  // (0,1).
  const auto horn = [](const Rational& gap) {
    const Rational a(1, 3), b(1, 2), c(1, 6), d(2, 3), g = gap, h = gap / 3, i = gap * d, k = gap / 2;
    return RationalPatch({{{0, 0, 0}, {a + h, 0, 0}, {a + i, a + h, 0}, {g, g, 0}},
                          {{0, 0, 0}, {b + h, 0, c + h / 2}, {d + i, b + h, c + i / 2}, {b + g, b + g, k}},
                          {{0, 0, 0}, {d + h, 0, d + h}, {1 + i, d + h, 1 + i}, {1 + g, 1 + g, 1 + g}}});
  };
  // x = 2 z + y z / 8 for y and z in [-1,2].
  const Rational e(1, 4);
  const RationalPatch x({{{-2 + e / 2, -1, -1}, {4 - e, -1, 2}}, {{-2 - e, 2, -1}, {4 + 2 * e, 2, 2}}});
  CHECK_FALSE(by_inverse(x, horn(0)));
  for (const long bits : {1, 20, 60}) {
    const IntersectionGraph graph = solved(x, horn(power_of_two(-bits))).graph;
    CHECK(graph.isolated_points.empty());
    CHECK(std::ranges::count_if(graph.nodes, [](const Node& n) { return !n.free.empty(); }) == 1);
  }
}

}  // namespace exsect::intersect_by_inverse_test
