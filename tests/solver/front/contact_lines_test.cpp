// Round patches that touch along a circle or a ruling, and near misses, which never do.
#include <exsect/solver/intersect_rational.h>

#include <functional>
#include <vector>

#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace exsect::contact_lines_test {
namespace {

/// (w cos, w sin, w) about the angle 0: (1 - t^2, 2 t, 1 + t^2), -1/2 <= t <= 1/2.
using Arc3 = std::array<Rational, 3>;
std::vector<Arc3> about_zero() {
  const Rational q(1, 4);
  return {{1 - q, -1, 1 + q}, {1 + q, 0, 1 - q}, {1 - q, 1, 1 + q}};
}
std::vector<Arc3> quarter() { return {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}}; }
/// The same, the angle a becoming pi - a.
std::vector<Arc3> opposite(std::vector<Arc3> arc) {
  for (Arc3& p : arc) p[0] = -p[0];
  return arc;
}

RationalPatch cylinder(const std::vector<Arc3>& arc, const Rational& radius, const Rational& x,
                       const Rational& from, const Rational& to) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const Arc3& p : arc) {
    net.emplace_back();
    for (const Rational& z : {from, to})
      net.back().push_back({radius * p[0] + x * p[2], radius * p[1], z * p[2], p[2]});
  }
  return RationalPatch::from_homogeneous(net);
}

/// The circle of this radius about (major,0) of the half plane, turned about the axis.
RationalPatch torus(const Rational& major, const Rational& minor) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const Arc3& a : about_zero()) {
    net.emplace_back();
    for (const Arc3& b : about_zero()) {
      const Rational radius = major * a[2] + minor * a[0];
      net.back().push_back({radius * b[0], radius * b[1], minor * a[1] * b[2], a[2] * b[2]});
    }
  }
  return RationalPatch::from_homogeneous(net);
}

RationalPatch moved(const RationalPatch& patch, const Rational& x) {
  return random_nets::image(patch, {{{1, 0, 0, x}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}});
}

/// By 36.9 degrees about the z axis, then by 22.6 about the x axis.
RationalPatch turned(const RationalPatch& patch) {
  const Rational c(3, 5), s(4, 5), d(12, 13), t(5, 13);
  return random_nets::image(
      random_nets::image(patch, {{{c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}),
      {{{1, 0, 0, 0}, {0, d, -t, 0}, {0, t, d, 0}, {0, 0, 0, 1}}});
}

/// Along z, from (r,0) to (r + 3 slope, 3): part of a cone about the z axis.
RationalPatch cone(const std::vector<Arc3>& arc, const Rational& r, const Rational& slope) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const Arc3& p : arc) {
    net.emplace_back();
    for (const Rational& z : {Rational(0), Rational(3)}) {
      const Rational radius = r + slope * z;
      net.back().push_back({radius * p[0], radius * p[1], z * p[2], p[2]});
    }
  }
  return RationalPatch::from_homogeneous(net);
}

struct Scene {
  const char* name;
  RationalPatch x;
  RationalPatch y;
};
std::vector<Scene> scenes() {
  const Rational third(1, 3);
  const RationalPatch rod = cylinder(about_zero(), 1, 0, 0, 1);
  const RationalPatch turned_square(
      {{{1, Rational(-3, 2), Rational(1, 2)}, {1, Rational(-3, 2), 0 + Rational(3, 2)}},
       {{1, Rational(1, 2), Rational(-1, 2)}, {1, Rational(1, 2), Rational(1, 2)}}});
  return {{"a rod on a plane", rod, turned_square},
          {"equal rods along a ruling", rod, cylinder(opposite(about_zero()), 1, 2, third, 1 + third)},
          {"a rod in a bore", rod, cylinder(about_zero(), 2, -1, third, 1 + third)},
          {"a sphere in a bore of its radius", torus(0, 1), cylinder(about_zero(), 1, 0, -third, 2 * third)},
          {"a sphere in a quarter of a bore", torus(0, 1), cylinder(quarter(), 1, 0, -third, 2 * third)},
          {"a torus in a bore", torus(3, 1), cylinder(about_zero(), 4, 0, -third, 2 * third)}};
}

/// One patch touches the other one along a curve that is no line of its parameters, perhaps of neither.
std::vector<Scene> curved_scenes() {
  const Rational third(1, 3);
  // The torus with its tube turned, so that it touches the plane x = 1; about the x axis.
  const random_nets::ProjectiveMap on_its_side = {{{0, 0, 1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 0, 1}}};
  std::vector<Arc3> upper = about_zero();
  for (Arc3& p : upper) p = {-p[1], p[0], p[2]};
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const Arc3& a : upper) {
    net.emplace_back();
    for (const Arc3& b : about_zero()) {
      const Rational radius = 3 * a[2] + a[0];
      net.back().push_back({radius * b[0], radius * b[1], a[1] * b[2], a[2] * b[2]});
    }
  }
  const RationalPatch lying = random_nets::image(RationalPatch::from_homogeneous(net), on_its_side);
  const RationalPatch table({{{1, -4, -5}, {1, 3, -6}}, {{1, -3, 1}, {1, 4, 0}}});
  const RationalPatch trapezoid({{{1, -4, -5}, {1, 4, -5}}, {{1, -3, 0}, {1, 3, 0}}});
  return {{"a torus on a table", lying, table},
          {"a torus on a trapezoid", lying, trapezoid},
          {"a turned sphere in a bore", turned(torus(0, 1)), cylinder(about_zero(), 1, 0, -1, 1)},
          {"a turned sphere in a cone", turned(torus(0, 5)),
           cone(about_zero(), Rational(25, 4), Rational(-3, 4))}};
}

void check_contact(const RationalPatch& x, const RationalPatch& y) {
  const IntersectResult result = intersect(x, y);
  REQUIRE(result.status == Status::complete);
  REQUIRE(result.graph.arcs.size() == 1);
  CHECK(result.graph.arcs[0].contact == Contact::tangential);
  CHECK(result.graph.nodes.size() == 2);
  CHECK(result.graph.count(ComponentShape::open) == 1);
}

}  // namespace

TEST_CASE("contact lines: one arc of contact, however the scene is written") {
  for (const auto& [name, x, y] : scenes()) {
    INFO(name);
    check_contact(x, y);
    const IntersectResult result = intersect(x, y);
    const IntersectResult exchanged = intersect(y, x.transposed());
    CHECK(difference(result.graph, exchanged.graph, {{3, 2, 0, 1}, {}}) == "");
    check_contact(x.elevated(3, 3), y);
    check_contact(random_nets::reparametrised(x, Rational(7, 5)), y);
    check_contact(x, random_nets::reparametrised(y.transposed(), Rational(2, 3)));
    const Rational far(100000000), inch(254, 10);
    for (const random_nets::ProjectiveMap& map : std::vector<random_nets::ProjectiveMap>{
             {{{inch, 0, 0, 0}, {0, inch, 0, 0}, {0, 0, inch, 0}, {0, 0, 0, 1}}},
             {{{Rational(3, 5), Rational(-4, 5), 0, 0},
               {Rational(4, 5), Rational(3, 5), 0, 0},
               {0, 0, 1, 0},
               {0, 0, 0, 1}}},
             {{{1, 0, 0, far}, {0, 1, 0, -far}, {0, 0, 1, far}, {0, 0, 0, 1}}},
             {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {Rational(1, 16), 0, Rational(1, 20), 1}}}})
      check_contact(random_nets::image(x, map), random_nets::image(y, map));
  }
}

TEST_CASE("contact lines: near misses are not answered by contact") {
  int complete = 0;
  for (const auto& [name, x, y] : scenes())
    for (const int digits : {3, 6, 12, 20})
      for (const int sign : {1, -1}) {
        INFO(name << ", 10^-" << digits << ", " << sign);
        const Rational e = sign / Rational(pow(Integer(10), static_cast<unsigned>(digits)));
        const IntersectResult result = intersect(x, moved(y, e));
        for (const Arc& arc : result.graph.arcs) CHECK(arc.contact == Contact::transversal);
        if (result.status == Status::complete) ++complete;
      }
  CHECK(complete == 48);
}

TEST_CASE("contact lines: along curves that are no lines of the parameters") {
  for (const auto& [name, x, y] : curved_scenes()) {
    INFO(name);
    const Rational far(100000000), inch(254, 10);
    const random_nets::ProjectiveMap scaled = {
        {{inch, 0, 0, far}, {0, inch, 0, -far}, {0, 0, inch, far}, {0, 0, 0, 1}}};
    for (const auto& [a, b] : std::vector<std::array<RationalPatch, 2>>{
             {x, y},
             {y, x},
             {random_nets::reparametrised(x, Rational(7, 5)), y.transposed()},
             {random_nets::image(x, scaled), random_nets::image(y, scaled)}}) {
      const IntersectResult result = intersect(a, b);
      REQUIRE(result.status == Status::complete);
      REQUIRE(!result.graph.arcs.empty());
      for (const Arc& arc : result.graph.arcs) {
        CHECK(arc.contact == Contact::tangential);
        CHECK(arc.beside);
      }
      CHECK(result.graph.count(ComponentShape::open) == 1);
      CHECK(result.graph.components.size() == 1);
    }
    for (const int digits : {3, 6, 12, 20})
      for (const int sign : {1, -1}) {
        INFO("10^-" << digits << ", " << sign);
        const IntersectResult result =
            intersect(x, moved(y, sign / Rational(pow(Integer(10), static_cast<unsigned>(digits)))));
        CHECK(result.status == Status::complete);
        for (const Arc& arc : result.graph.arcs) CHECK(arc.contact == Contact::transversal);
      }
  }
}

}  // namespace exsect::contact_lines_test
