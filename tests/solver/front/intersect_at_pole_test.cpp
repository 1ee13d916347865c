// A pole of one patch inside the other one: domes against exact arithmetic, octants of spheres against their
// sections.
#include "intersect_at_pole.h"

#include <exsect/algebra/nearest_double.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/redrawn.h>

#include <algorithm>
#include <cmath>

#include "filter/filter.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::intersect_at_pole_test {
namespace {

using random_pairs::Generator;
using Net = std::vector<std::vector<Point>>;

/// A quarter of a dome over the plane, of which the side u = 0 is the pole, in the origin.
BezierPatch dome(Generator& generator) {
  const auto jitter = [&] { return Rational(random_pairs::integer(generator, -4, 4), 32); };
  ControlNet net;
  for (long i = 0; i < 3; ++i)
    for (long j = 0; j < 3; ++j) {
      const Rational out(i, 2);
      const Point p = {out * (2 - j + jitter()), out * (j + jitter()), -out * out + out * jitter() / 4};
      net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = i == 0 ? Point{0, 0, 0} : p;
    }
  return BezierPatch(net);
}

/// A steep sheet with the origin at the place.
BezierPatch sheet(Generator& generator, const Rational& r, const Rational& s) {
  const auto jitter = [&] { return Rational(random_pairs::integer(generator, -8, 8), 64); };
  ControlNet net;
  for (long i = 0; i < 3; ++i)
    for (long j = 0; j < 3; ++j)
      net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {2 * i + jitter(), j + jitter(),
                                                                       2 * j - i + jitter()};
  const Point at = BezierPatch(net)(r, s);
  for (auto& row : net)
    for (Point& p : row) p = p - at;
  return BezierPatch(net);
}

IntersectResult solved_in_doubles(const RationalPatch& x, const RationalPatch& y, const Run& run) {
  return intersect_in_doubles(x, y, run);
}

/// By the pole's proof, and the rest by any.
IntersectResult blown_up(const RationalPatch& x, const RationalPatch& y) {
  const auto solve = [](const RationalPatch& a, const RationalPatch& b, const Run&) {
    return intersect(a, b);
  };
  const auto result = intersect_at_pole(x, y, Run(), solve);
  REQUIRE(result);
  REQUIRE(result->status == Status::complete);
  return *result;
}

/// An octant of a sphere of radius 1 about the origin; the side u = 1 is its pole (0,0,1).
Net octant() {
  return {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
          {{1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
}
const std::vector<std::vector<Rational>> kWeights = {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}};

/// Through (0,0,height), with the normal.
Net plane(const Point& normal, const Rational& height) {
  Net net;
  for (const Rational& a : {Rational(-7, 13), Rational(6, 13)})
    for (const Rational& b : {Rational(-5, 11), Rational(6, 11)}) {
      if (b < 0) net.emplace_back();
      net.back().push_back({a, b, height - (a * normal[0] + b * normal[1]) / normal[2]});
    }
  return net;
}

template <class Map>
Net mapped(Net net, const Map& map) {
  for (auto& row : net)
    for (Point& p : row) p = map(p);
  return net;
}

std::size_t arcs_at(const IntersectionGraph& graph, int node) {
  return static_cast<std::size_t>(
      std::ranges::count_if(graph.arcs, [&](const Arc& arc) { return arc.from == node || arc.to == node; }));
}

const Node* pole_of(const IntersectionGraph& graph) {
  for (const Node& node : graph.nodes)
    if (!node.free.empty()) return &node;
  return nullptr;
}

/// Of sheets with the pole at the place; counts what is found, and arcs.
std::array<int, 2> compare_with_exact(const Rational& r, const Rational& s, std::uint64_t seeds) {
  int complete = 0, arcs = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    INFO("pole at " << to_double(r) << ", " << to_double(s) << ", seed " << seed);
    Generator generator(seed);
    const BezierPatch x = dome(generator), y = sheet(generator, r, s);
    const IntersectResult exact = intersect(x, y);
    REQUIRE(exact.status == Status::complete);
    const auto found = intersect_at_pole(x, y, Run(), solved_in_doubles);
    const auto exchanged = intersect_at_pole(y, x, Run(), solved_in_doubles);
    REQUIRE(found.has_value() == exchanged.has_value());
    if (!found) continue;
    ++complete;
    arcs += static_cast<int>(found->graph.arcs.size());
    CHECK(difference(exact.graph, found->graph, {}) == "");
    REQUIRE(pole_of(found->graph));
    CHECK(pole_of(found->graph)->free == std::vector{Parameter::v});
    CHECK(pole_of(exchanged->graph)->free == std::vector{Parameter::s});
  }
  return {complete, arcs};
}

}  // namespace

TEST_CASE("intersect_at_pole: domes on sheets have the graph of exact arithmetic") {
  const auto [complete, arcs] = compare_with_exact(Rational(1, 2), Rational(1, 3), 16);
  CHECK(complete >= 12);
  CHECK(arcs >= 6);
}

TEST_CASE("intersect_at_pole: poles on sides and in corners have the graph of exact arithmetic") {
  int complete = 0, arcs = 0;
  for (const Rational& r : {Rational(0), Rational(1, 2), Rational(1)})
    for (const Rational& s : {Rational(0), Rational(1)}) {
      const auto found = compare_with_exact(r, s, 4);
      complete += found[0];
      arcs += found[1];
    }
  CHECK(complete >= 16);
  CHECK(arcs >= 4);
}

TEST_CASE("intersect_at_pole: planes through the pole of an octant") {
  // By the sign of normal . (cos t, sin t, 0): an arc of the section in the pole's tangent plane, or none.
  const std::vector<std::pair<Point, std::size_t>> cases = {{{1, -1, Rational(1, 3)}, 1},
                                                            {{1, -2, Rational(1, 3)}, 1},
                                                            {{-3, 1, Rational(2)}, 1},
                                                            {{1, 1, 3}, 0},
                                                            {{0, 0, 1}, 0},
                                                            {{1, Rational(1, 1000), 1}, 0}};
  const auto turned = [](const Point& p) -> Point {
    return {Rational(254, 10) * (Rational(3, 5) * p[0] - Rational(4, 5) * p[2]), Rational(254, 10) * p[1],
            Rational(254, 10) * (Rational(4, 5) * p[0] + Rational(3, 5) * p[2])};
  };
  const auto moved = [](const Point& p) -> Point {
    return {p[0] + 100000000, p[1] - 200000000, p[2] + 300000000};
  };
  for (const auto& [normal, arcs] : cases) {
    INFO("normal " << to_double(normal[0]) << " " << to_double(normal[1]) << " " << to_double(normal[2]));
    const Net first = octant(), second = plane(normal, 1);
    const RationalPatch x(first, kWeights), y(second);
    const IntersectResult result = intersect(x, y);
    REQUIRE(result.status == Status::complete);
    const Node* pole = pole_of(result.graph);
    REQUIRE(pole);
    CHECK(arcs_at(result.graph, pole->id) == arcs);
    CHECK(pole->on == std::vector<Side>{{Parameter::u, 1}});
    CHECK(pole->box[2].lower == Rational(7, 13));
    CHECK(pole->box[3].upper == Rational(5, 11));
    CHECK(result.graph.isolated_points.size() == (arcs == 0 ? 1 : 0));
    const auto at_pole =
        intersect_at_pole(x, y, Run(), solved_in_doubles);  // by blow-up, not by the inverse of y
    REQUIRE(at_pole);
    CHECK(difference(result.graph, at_pole->graph, {}) == "");
    for (const Arc& arc : result.graph.arcs)
      for (const PolylineVertex& vertex : arc.polyline) {
        const auto& p = vertex.point;
        CHECK(std::abs(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1) < 1e-9);
        CHECK(std::abs(to_double(normal[0]) * p[0] + to_double(normal[1]) * p[1] +
                       to_double(normal[2]) * (p[2] - 1)) < 1e-9);
      }
    for (const auto& other :
         {intersect(RationalPatch(mapped(first, turned), kWeights), RationalPatch(mapped(second, turned))),
          intersect(RationalPatch(mapped(first, moved), kWeights), RationalPatch(mapped(second, moved)))})
      CHECK(difference(result.graph, other.graph, {}) == "");
    CHECK(difference(result.graph, intersect(y, x).graph, {{2, 3, 0, 1}, {}}) == "");
    CHECK(pole_of(intersect(x.transposed(), y).graph)->free == std::vector{Parameter::u});
    CHECK(difference(result.graph, intersect(x.restricted_to(1, 0, 0, 1), y).graph, {{0, 1, 2, 3}, {true}}) ==
          "");
  }
}

TEST_CASE("intersect_at_pole: a pole on a side of the other patch, and just beside it") {
  // The plane of the case above over x >= 0, and over x <= 0, in which the arc is not.
  const RationalPatch x(octant(), kWeights);
  const auto half = [](const Rational& from, const Rational& to) {
    const auto at = [](const Rational& a, const Rational& b) -> Point { return {a, b, 1 - 3 * (a - b)}; };
    const Rational low(-5, 11), high(9, 11);
    return RationalPatch({{at(from, low), at(from, high)}, {at(to, low), at(to, high)}});
  };
  for (const auto& [to, arcs] :
       {std::pair(Rational(1), std::size_t{1}), std::pair(Rational(-1), std::size_t{0})}) {
    const IntersectResult result = intersect(x, half(0, to));
    REQUIRE(result.status == Status::complete);
    const Node* pole = pole_of(result.graph);
    REQUIRE(pole);
    CHECK(pole->on == std::vector<Side>{{Parameter::u, 1}, {Parameter::r, 0}});
    CHECK(arcs_at(result.graph, pole->id) == arcs);
    CHECK(result.graph.isolated_points.size() == 1 - arcs);
    CHECK(difference(result.graph, intersect(half(0, to), x).graph, {{2, 3, 0, 1}, {}}) == "");
    for (const int bits : {12, 40, 70}) {
      const IntersectResult inside = intersect(x, half(-to * power_of_two(-bits), to));
      CHECK((pole_of(inside.graph) == nullptr || pole_of(inside.graph)->on.size() == 1));
      CHECK(pole_of(intersect(x, half(to * power_of_two(-bits), to)).graph) == nullptr);
    }
  }
}

TEST_CASE("intersect_at_pole: octants that touch in a common pole, and nearly do") {
  const auto inside = [](const Point& move) {
    return RationalPatch(mapped(octant(), [&](const Point& p) -> Point { return 2 * p + move; }), kWeights);
  };
  const auto scaled = [](const Point& p) -> Point {
    return {Rational(254, 10) * (Rational(3, 5) * p[0] - Rational(4, 5) * p[2]) + 100000000,
            Rational(254, 10) * p[1], Rational(254, 10) * (Rational(4, 5) * p[0] + Rational(3, 5) * p[2])};
  };
  const RationalPatch x(octant(), kWeights), y = inside({0, 0, -1});
  const auto far = [&](const RationalPatch& patch) {
    Net net(3, std::vector<Point>(3));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = scaled(patch.point(i, j));
    return RationalPatch(net, kWeights);
  };
  for (const IntersectResult& result : {intersect(x, y), intersect(y, x), intersect(far(x), far(y)),
                                        intersect(x.restricted_to(1, 0, 0, 1), y)}) {
    REQUIRE(result.status == Status::complete);
    CHECK(result.graph.arcs.empty());
    REQUIRE(result.graph.isolated_points.size() == 1);
    const Node& pole = result.graph.nodes.front();
    CHECK(pole.free == std::vector{Parameter::v, Parameter::s});
    CHECK(pole.on.size() == 2);
    CHECK(pole.kinds == std::vector{NodeKind::boundary});
  }
  for (const int bits : {10, 30, 60})
    for (const int sign : {-1, 1})
      for (const Point& direction : {Point{0, 0, 1}, Point{1, 1, 0}}) {
        const IntersectResult near =
            intersect(x, inside(Rational(sign) * power_of_two(-bits) * direction + Point{0, 0, -1}));
        CHECK(pole_of(near.graph) == nullptr);
      }
}

TEST_CASE("intersect_at_pole: octants through a common pole") {
  // Turned about it by a quaternion q. Their tangent planes in the pole have the line of e_3 x R e_3 in
  // common: each half of it that lies in both quadrants is the direction of an arc.
  int complete = 0, arcs = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    std::array<Rational, 4> q;
    for (Rational& k : q) k = random_pairs::integer(generator, -5, 5);
    const Rational square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    const Point axis = {q[1], q[2], q[3]}, pole = {0, 0, 1};
    if (square == 0 || (q[1] == 0 && q[2] == 0)) continue;
    const auto turned = [&](const Point& p, const Rational& way) -> Point {
      const Point once = cross(axis, p);
      return p + Rational(2 / square) * (Rational(way * q[0]) * once + cross(axis, once));
    };
    const auto about_pole = [&](const Point& p) { return pole + turned(p - pole, 1); };
    std::size_t expected = 0;
    for (const long half : {1, -1}) {
      const Point d = Rational(half) * cross(pole, turned(pole, 1)), e = turned(d, -1);
      expected += d[0] > 0 && d[1] > 0 && e[0] > 0 && e[1] > 0 ? 1 : 0;
    }
    const RationalPatch x(octant(), kWeights), y(mapped(octant(), about_pole), kWeights);
    const IntersectResult result = intersect(x, y);
    for (const IntersectResult& other : {intersect(y, x), intersect(x, y.transposed())})
      CHECK(other.status == result.status);
    if (result.status != Status::complete) continue;
    ++complete;
    const Node* node = pole_of(result.graph);
    REQUIRE(node);
    CHECK(node->free == std::vector{Parameter::v, Parameter::s});
    CHECK(arcs_at(result.graph, node->id) == expected);
    arcs += static_cast<int>(expected);
    CHECK(difference(result.graph, intersect(y, x).graph, {{2, 3, 0, 1}, {}}) == "");
    CHECK(difference(result.graph, intersect(x, y.transposed()).graph, {{0, 1, 3, 2}, {}}) == "");
    CHECK(difference(result.graph, intersect(x, y.restricted_to(1, 0, 0, 1)).graph,
                     {{0, 1, 2, 3}, {false, false, true, false}}) == "");
    const Point other_centre = about_pole({0, 0, 0});
    for (const Arc& arc : result.graph.arcs)
      for (const PolylineVertex& vertex : arc.polyline) {
        const auto& p = vertex.point;
        CHECK(std::abs(std::hypot(p[0], p[1], p[2]) - 1) < 1e-9);
        CHECK(std::abs(std::hypot(p[0] - to_double(other_centre[0]), p[1] - to_double(other_centre[1]),
                                  p[2] - to_double(other_centre[2])) -
                       1) < 1e-9);
      }
  }
  CHECK(complete >= 8);
  CHECK(arcs >= 2);
}

TEST_CASE("intersect_at_pole: a plane through the axis has the constant parameter of its section") {
  const Net upright = {{{-1, -2, Rational(1, 2)}, {-1, -2, Rational(3, 2)}},
                       {{2, 4, Rational(1, 2)}, {2, 4, Rational(3, 2)}}};
  const IntersectResult result = intersect(RationalPatch(octant(), kWeights), RationalPatch(upright));
  REQUIRE(result.status == Status::complete);
  REQUIRE(result.graph.arcs.size() == 1);
  CHECK(result.graph.nodes.size() == 2);
  const double v = result.graph.arcs[0].polyline.back().parameters[1];
  CHECK(std::abs(2 * v / (1 - v * v) - 2) < 1e-4);  // tan of the longitude
}

TEST_CASE("intersect_at_pole: a pole at irrational parameters of a sphere") {
  // (-2/3,4/3,4/3) on an octant of radius 2 is not at rational parameters; the arc leaves along a parallel.
  const auto around = [](const Point& p) -> Point {
    return {Rational(2, 3) - 2 * p[0], 2 * p[1] - Rational(4, 3), 2 * p[2] - Rational(1, 3)};
  };
  const RationalPatch x(octant(), kWeights), y(mapped(octant(), around), kWeights);
  const IntersectResult result = intersect(x, y);
  REQUIRE(result.status == Status::complete);
  REQUIRE(result.graph.arcs.size() == 1);
  const Node* pole = pole_of(result.graph);
  REQUIRE(pole);
  CHECK(pole->box[2].lower < pole->box[2].upper);
  CHECK(pole->box[2].width() < power_of_two(-70));
  for (const PolylineVertex& vertex : result.graph.arcs[0].polyline) {
    const auto& p = vertex.point;
    CHECK(std::abs(std::hypot(p[0], p[1], p[2]) - 1) < 1e-9);
    CHECK(std::abs(std::hypot(p[0] - 2.0 / 3, p[1] + 4.0 / 3, p[2] + 1.0 / 3) - 2) < 1e-9);
  }
}

TEST_CASE("intersect_at_pole: an octant's sides in planes and beside them") {
  // z is height, the pole (0,0,1); the plane through it holds (c,s,0) and leans by `lean`.
  const RationalPatch x(octant(), kWeights);
  const auto sheet = [](const Rational& c, const Rational& s, const Rational& lean) {
    const auto at = [&](const Rational& i, const Rational& j) -> Point {
      return {i * c - j * lean * s, i * s + j * lean * c, 1 + j};
    };
    return RationalPatch({{at(-2, -2), at(-2, 1)}, {at(2, -2), at(2, 1)}});
  };
  // Upright: the sides v = 0 and v = 1 themselves, from the pole to the equator. Leaning, a small circle that
  // touches the direction of this side: inside of the octant, or outside.
  for (const bool at_one : {false, true})
    for (const int lean : {-1, 0, 1}) {
      INFO("v = " << at_one << ", lean " << lean);
      const RationalPatch y = at_one ? sheet(0, 1, lean) : sheet(1, 0, lean);
      const IntersectResult result = blown_up(x, y);
      CHECK(difference(result.graph, intersect(x, y).graph, {}) == "");  // by the inverse of y
      const Node* pole = pole_of(result.graph);
      REQUIRE(pole);
      const bool is_inside = at_one ? lean > 0 : lean < 0;
      REQUIRE(arcs_at(result.graph, pole->id) == (lean == 0 || is_inside ? std::size_t{1} : std::size_t{0}));
      for (const Arc& arc : result.graph.arcs) {
        CHECK(arc.place == (lean == 0 ? ArcPlace::patch_boundary : ArcPlace::interior));
        CHECK(arc.contact == Contact::transversal);
        for (const PolylineVertex& vertex : arc.polyline) {
          const auto& p = vertex.point;
          CHECK(std::abs(std::hypot(p[0], p[1], p[2]) - 1) <= arc.error_bound + 1e-14);
          const double off = at_one ? p[0] + lean * (p[2] - 1) : p[1] - lean * (p[2] - 1);
          CHECK(std::abs(off) <= 1.5 * arc.error_bound + 1e-14);
          if (lean == 0) CHECK(vertex.parameters[1] == (at_one ? 1 : 0));
        }
      }
      CHECK(difference(result.graph, blown_up(y, x).graph, {{2, 3, 0, 1}, {}}) == "");
    }
}

TEST_CASE("intersect_at_pole: the direction of an end, at irrational parameters of a sphere") {
  // A sphere of radius 13 through (0,0,1) with the normal (3,4,12) there, that is at irrational parameters of
  // the octant about the axis of x. Its section leaves along (4,-3,0) and (-4,3,0), bent towards (3,4,0) or
  // back. The octant is turned so that this is the direction of its sides v = 0 or v = 1.
  const auto around = [](const Point& p) -> Point { return {13 * p[2] - 3, 13 * p[0] - 4, 13 * p[1] - 11}; };
  const RationalPatch y(mapped(octant(), around), kWeights);
  for (const int sign : {-1, 1})
    for (const bool at_one : {false, true}) {
      INFO("direction " << sign << " (4,-3), v = " << at_one);
      const Rational c = Rational(4 * sign, 5), s = Rational(-3 * sign, 5);  // of the side
      const auto turned = [&](const Point& p) -> Point {
        return at_one ? Point{s * p[0] + c * p[1], s * p[1] - c * p[0], p[2]}
                      : Point{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
      };
      const RationalPatch x(mapped(octant(), turned), kWeights);
      const IntersectResult result = blown_up(x, y);
      CHECK(difference(result.graph, intersect(x, y).graph, {}) == "");  // by the inverse of y
      const Node* pole = pole_of(result.graph);
      REQUIRE(pole);
      CHECK(pole->box[2].lower < pole->box[2].upper);
      // In the plane of both, 3 x + 4 y + 11 (z - 1) = 0, z < 1: it leads to 3 x + 4 y > 0, which is to the
      // left of (4,-3), as (3,4) is.
      const bool is_inside = (sign > 0) != at_one;
      CHECK(arcs_at(result.graph, pole->id) == (is_inside ? std::size_t{1} : std::size_t{0}));
      CHECK(difference(result.graph, blown_up(y, x).graph, {{2, 3, 0, 1}, {}}) == "");
    }
}

TEST_CASE("intersect_at_pole: a polynomial cone that leaves its apex along a side") {
  // The plane's side lies along the ruling (1,1,1) of the cone x z = y^2, or along (2,1,-1), outside of it.
  const auto at = [](const Rational& a, const Rational& b) -> Point { return {a, b, 0}; };
  const auto cone_to = [](const Point& p, const Point& q) {
    return RationalPatch({{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {p, Point{0, Rational(1, 2), 0}, q}});
  };
  const RationalPatch cone = cone_to({1, 0, 0}, {0, 0, 1});
  const auto plane_on = [&](const Point& way) {  // its side s = 0 is from -way to way
    const auto on = [&](int k, int up) { return Rational(k) * way + Rational(up) * at(0, 1); };
    return RationalPatch({{on(-1, 0), on(-1, 1)}, {on(1, 0), on(1, 1)}});
  };
  const auto placed = [](const RationalPatch& patch) {
    Net net;
    for (int i = 0; i <= patch.degree_u(); ++i) {
      net.emplace_back();
      for (int j = 0; j <= patch.degree_v(); ++j) {
        const Point p = patch.point(i, j);
        net.back().push_back({Rational(254, 10) * (Rational(3, 5) * p[0] - Rational(4, 5) * p[2]) + 100000000,
                              Rational(254, 10) * p[1],
                              Rational(254, 10) * (Rational(4, 5) * p[0] + Rational(3, 5) * p[2])});
      }
    }
    return RationalPatch(net);
  };
  IntersectOptions exactly;
  exactly.exact = true;
  for (const auto& [way, arcs] : {std::pair(Point{1, 1, 1}, std::size_t{1}), {Point{2, 1, -1}, 0}}) {
    const RationalPatch y = plane_on(way);
    const IntersectResult result = intersect(cone, y);
    REQUIRE(result.status == Status::complete);
    const Node* pole = pole_of(result.graph);
    REQUIRE(pole);
    CHECK(pole->on == std::vector<Side>{{Parameter::u, 0}, {Parameter::s, 0}});
    CHECK(arcs_at(result.graph, pole->id) == arcs);
    CHECK(result.graph.isolated_points.size() == 1 - arcs);
    for (const Arc& arc : result.graph.arcs) {
      CHECK(arc.place == ArcPlace::patch_boundary);
      for (const PolylineVertex& vertex : arc.polyline) CHECK(vertex.parameters[3] == 0);
    }
    CHECK(difference(result.graph, intersect(cone, y, exactly).graph, {}) == "");
    CHECK(difference(result.graph, intersect(placed(cone), placed(y)).graph, {}) == "");
    CHECK(difference(result.graph, intersect(y, cone).graph, {{2, 3, 0, 1}, {}}) == "");
    CHECK(difference(result.graph, intersect(cone.restricted_to(1, 0, 0, 1), y).graph,
                     {{0, 1, 2, 3}, {true}}) == "");
  }
}

TEST_CASE("intersect_at_pole: constant parameters out of a common pole, whichever side it is") {
  // Heights over the quadrant: x^2 and y^2 cross in the parabola over x = y, x^2 + y^2 and 2 (x^2 - x y +
  // y^2) touch in it.
  const auto cup = [](const Rational& p, const Rational& q, const Rational& r) {
    const Rational half(1, 2), quarter(1, 4);
    const Point o = {0, 0, 0};
    return RationalPatch({{o, o, o},
                          {{half, 0, 0}, {quarter, quarter, 0}, {0, half, 0}},
                          {{1, 0, p}, {half, half, q}, {0, 1, r}}});
  };
  for (const bool is_contact : {false, true}) {
    const RationalPatch x = is_contact ? cup(1, 0, 1) : cup(1, 0, 0),
                        y = is_contact ? cup(2, -1, 2) : cup(0, 0, 1);
    const IntersectResult result = blown_up(x, y);
    REQUIRE(result.graph.arcs.size() == 1);
    CHECK(result.graph.arcs[0].contact == (is_contact ? Contact::tangential : Contact::transversal));
    CHECK(!result.coarse);
    const RationalPatch reversed = y.restricted_to(1, 0, 0, 1);
    for (const RationalPatch& other : {y, reversed, y.transposed(), reversed.transposed()})
      for (const bool is_exchanged : {false, true}) {
        const RationalPatch &first = is_exchanged ? other : x, &second = is_exchanged ? x : other;
        const IntersectResult image = blown_up(first, second);
        CHECK(image.graph.nodes.size() == result.graph.nodes.size());
        REQUIRE(image.graph.arcs.size() == 1);
        CHECK(image.graph.arcs[0].contact == result.graph.arcs[0].contact);
        for (const PolylineVertex& vertex : image.graph.arcs[0].polyline) {
          std::array<Rational, 4> at;
          for (std::size_t j = 0; j < 4; ++j) at[j] = from_double(vertex.parameters[j]);
          const Point p = first(at[0], at[1]), q = second(at[2], at[3]);
          for (std::size_t c = 0; c < 3; ++c) {
            CHECK(std::abs(to_double(p[c]) - to_double(q[c])) < 1e-5);
            CHECK(std::abs(to_double(p[c]) - vertex.point[c]) < 1e-5);
          }
        }
      }
  }
}

TEST_CASE("intersect_at_pole: a pole that is not on the other patch is never taken for one that is") {
  const RationalPatch x(octant(), kWeights);
  for (const Point& normal : {Point{1, -1, Rational(1, 3)}, Point{0, 0, 1}})
    for (const int digits : {3, 6, 12, 20})
      for (const int sign : {-1, 1}) {
        INFO("10^-" << digits << " " << sign);
        Rational off = sign;
        for (int i = 0; i < digits; ++i) off /= 10;
        const IntersectResult result = intersect(x, RationalPatch(plane(normal, 1 + off)));
        CHECK(pole_of(result.graph) == nullptr);
        if (digits <= 6) CHECK(result.status == Status::complete);
      }
}

TEST_CASE("intersect_at_pole: arcs keep the tolerance that is asked for, and have the same nodes") {
  const IntersectResult result =
      intersect(RationalPatch(octant(), kWeights), RationalPatch(plane({1, -1, Rational(1, 3)}, 1)));
  std::size_t vertices = 0;
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    const IntersectResult drawn = redrawn(result, {.tolerance = tolerance});
    REQUIRE(drawn.status == Status::complete);
    CHECK(!drawn.coarse);
    CHECK(difference(result.graph, drawn.graph, {}) == "");
    CHECK(drawn.graph.arcs[0].polyline.size() > vertices);
    vertices = drawn.graph.arcs[0].polyline.size();
  }
}

}  // namespace exsect::intersect_at_pole_test
