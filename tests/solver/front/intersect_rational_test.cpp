// Pairs of any bidegrees up to (3,3): against the oracle, against biquadratic pairs that are elevated, and
// under maps that rename only.
#include <exsect/solver/intersect.h>
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "filter/filter.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/oracle.h"
#include "support/random_nets.h"
#include "support/random_pairs.h"

namespace exsect::intersect_rational_test {
namespace {

using random_nets::Generator;
using random_nets::image;
using random_nets::Net;
using random_nets::Nets;
using random_nets::projective_map;
using random_nets::reparametrised;

using Degrees = std::array<int, 4>;
const std::array<Degrees, 7> many_degrees = {
    {{3, 3, 3, 3}, {3, 3, 2, 2}, {1, 3, 3, 1}, {3, 2, 1, 1}, {3, 3, 1, 2}, {2, 3, 2, 3}, {1, 1, 3, 3}}};

std::array<double, 3> rounded(const Point& p) { return {to_double(p[0]), to_double(p[1]), to_double(p[2])}; }

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                   (a[2] - b[2]) * (a[2] - b[2]));
}

/// Every vertex of every arc is, as a point and by its parameters, on both patches within twice its bound.
void check_vertices(const RationalPatch& x, const RationalPatch& y, const IntersectionGraph& graph) {
  for (const Arc& arc : graph.arcs) {
    const std::size_t step = std::max<std::size_t>(1, arc.polyline.size() / 5);
    for (std::size_t i = 0; i < arc.polyline.size(); i += step) {
      const auto& [w, p] = arc.polyline[i];
      const auto on_x = rounded(x(from_double(w[0]), from_double(w[1])));
      const auto on_y = rounded(y(from_double(w[2]), from_double(w[3])));
      const double rounding = 1e-13 * (1 + distance(p, {0, 0, 0}));
      CHECK(distance(p, on_x) <= 2 * arc.error_bound + rounding);
      CHECK(distance(p, on_y) <= 2 * arc.error_bound + rounding);
    }
  }
}

void check_boundary(const IntersectionGraph& graph, const oracle::Intersection& expected) {
  const auto is_on_side = [](const Node& node) { return !node.on.empty(); };
  CHECK(static_cast<std::size_t>(std::count_if(graph.nodes.begin(), graph.nodes.end(), is_on_side)) ==
        expected.boundary_points.size());
  for (const oracle::Vector4& z : expected.boundary_points) {
    const auto near = [&](const Node& node) {
      return is_on_side(node) && std::equal(z.begin(), z.end(), node.approx.begin(),
                                            [](double a, double b) { return std::abs(a - b) < 1e-7; });
    };
    CHECK(std::count_if(graph.nodes.begin(), graph.nodes.end(), near) == 1);
  }
}

struct Tally {
  int complete = 0;
  int compared = 0;
  int curves = 0;
};

void compare_with_oracle(const Nets& nets, Tally& tally) {
  const RationalPatch x = nets.first();
  const RationalPatch y = nets.second();
  const IntersectResult result = intersect(x, y);
  if (result.status != Status::complete) return;
  ++tally.complete;
  check_vertices(x, y, result.graph);
  const auto expected = oracle::intersect(x, y);
  if (!expected.conclusive()) return;
  ++tally.compared;
  tally.curves += static_cast<int>(result.graph.components.size());
  CHECK(result.graph.count(ComponentShape::closed) == expected.closed());
  CHECK(result.graph.count(ComponentShape::open) == expected.open());
  CHECK(result.graph.isolated_points.empty());
  check_boundary(result.graph, expected);
}

/// Complete, `least` of them but for rare near degeneracies, and right.
void compare_many(int count, int least, const std::function<Nets(Generator&, const Degrees&)>& family) {
  for (const Degrees& degrees : many_degrees) {
    Tally tally;
    for (int seed = 1; seed <= count; ++seed) {
      INFO("seed " << seed << ", degrees " << degrees[0] << degrees[1] << degrees[2] << degrees[3]);
      Generator generator(static_cast<std::uint64_t>(seed));
      compare_with_oracle(family(generator, degrees), tally);
    }
    INFO("degrees " << degrees[0] << degrees[1] << degrees[2] << degrees[3] << ": complete " << tally.complete
                    << ", compared " << tally.compared << ", curves " << tally.curves);
    CHECK(tally.complete >= least);
    CHECK(tally.compared >= least / 2);
    CHECK(tally.curves >= count / 4);
  }
}

Net scaled(const Net& net, const Rational& scale, const Point& shift) {
  Net result = net;
  for (auto& row : result)
    for (Point& p : row) p = scale * p + shift;
  return result;
}

/// Bernstein coefficients of a^n, a = u - 1/2, for cubics.
Rational power_of_a(int n, int i) {
  const std::array<std::array<Rational, 4>, 4> powers = {
      {{1, 1, 1, 1},
       {Rational(-1, 2), Rational(-1, 6), Rational(1, 6), Rational(1, 2)},
       {Rational(1, 4), Rational(-1, 12), Rational(-1, 12), Rational(1, 4)},
       {Rational(-1, 8), Rational(1, 8), Rational(-1, 8), Rational(1, 8)}}};
  return powers[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)];
}

/// The bicubic graph over the middle of a height by its Bernstein coefficients, and a plane at height 0: both
/// over rectangles, or over quadrilaterals with one corner moved.
template <class Height>
IntersectResult graph_and_plane(const Height& height, const Rational& left_of_middle,
                                const Rational& moved = 0) {
  Net graph(4);
  Net plane(2);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Rational a = power_of_a(1, i), b = power_of_a(1, j), bend = moved * a * b;
      graph[static_cast<std::size_t>(i)].push_back({a + bend, b + bend, height(i, j)});
    }
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      plane[static_cast<std::size_t>(i)].push_back(
          {i == 0 ? Rational(-left_of_middle) : Rational(Rational(3, 2) + j * moved),
           Rational(Rational(5 * j - 2, 2) + i * j * moved), Rational(0)});
  return intersect(RationalPatch(graph), RationalPatch(plane));
}
/// Of height a^2 + sign b^2 + a^3.
IntersectResult graph_and_plane(int sign, const Rational& left_of_middle) {
  return graph_and_plane(
      [&](int i, int j) -> Rational { return power_of_a(2, i) + sign * power_of_a(2, j) + power_of_a(3, i); },
      left_of_middle);
}
/// Of height (a - b)^2 (1 + a + b): the plane touches along the diagonal u = v.
IntersectResult contact_along_diagonal(const Rational& moved) {
  return graph_and_plane(
      [](int i, int j) -> Rational {
        const auto term = [&](int m, int n) -> Rational { return power_of_a(m, i) * power_of_a(n, j); };
        return term(2, 0) - 2 * term(1, 1) + term(0, 2) + term(3, 0) - term(2, 1) - term(1, 2) + term(0, 3);
      },
      Rational(1, 2), moved);
}

}  // namespace

TEST_CASE("intersect rational: agrees with the oracle on doubles") {
  compare_many(12, 12, [](Generator& g, const Degrees& d) { return random_nets::crossing(g, d, true); });
}

TEST_CASE("intersect rational: agrees with the oracle on small rationals") {
  compare_many(12, 11, [](Generator& g, const Degrees& d) { return random_nets::crossing(g, d, false); });
}

TEST_CASE("intersect rational: agrees with the oracle on scattered control points") {
  compare_many(8, 6, [](Generator& g, const Degrees& d) { return random_nets::scattered(g, d); });
}

TEST_CASE("intersect rational: biquadratic pairs that are elevated have the same graph") {
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_pairs::Pair pair = seed % 4 == 0   ? random_pairs::loop(generator)
                                    : seed % 4 == 1 ? random_pairs::doubles(generator)
                                    : seed % 4 == 2 ? random_pairs::small_rationals(generator)
                                                    : random_pairs::scattered(generator);
    const IntersectResult elevated = intersect_in_doubles(pair.x, pair.y, {});
    if (elevated.status != Status::complete) continue;
    ++complete;
    CHECK(difference(intersect(pair.x, pair.y).graph, elevated.graph, {}) == "");
  }
  CHECK(complete >= 57);  // errors are larger than those of biquadratic pairs
}

TEST_CASE("intersect rational: the same graph of a model that is exchanged, scaled and far away") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Nets nets = random_nets::crossing(generator, many_degrees[seed % many_degrees.size()], true);
    const RationalPatch x = nets.first();
    const RationalPatch y = nets.second();
    const IntersectResult expected = intersect(x, y);
    REQUIRE(expected.status == Status::complete);
    const auto agrees = [&](const RationalPatch& a, const RationalPatch& b, const Renaming& renaming) {
      const IntersectResult other = intersect(a, b);
      CAPTURE(other.incomplete.empty() ? "" : other.incomplete[0].why);
      CHECK(other.status == Status::complete);
      CHECK(difference(expected.graph, other.graph, renaming) == "");
    };
    agrees(y, x, {{2, 3, 0, 1}, {}});
    agrees(x.transposed(), y, {{1, 0, 2, 3}, {}});
    agrees(x.restricted_to(1, 0, 0, 1), y, {{0, 1, 2, 3}, {true, false, false, false}});
    for (const auto& [scale, shift] :
         {std::pair{Rational(127, 5), Rational(0)}, std::pair{Rational(1, 3), Rational(100000000)},
          std::pair{power_of_two(-150), Rational(0)}}) {
      const Point by = {shift, -shift, shift / 7};
      agrees(RationalPatch(scaled(nets.x, scale, by)), RationalPatch(scaled(nets.y, scale, by)), {});
    }
  }
}

TEST_CASE("intersect rational: small closed curves") {
  int closed = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    Tally tally;
    const Nets nets = random_nets::loop(generator, seed % 2 == 0 ? Degrees{3, 3, 1, 1} : Degrees{3, 2, 3, 3});
    compare_with_oracle(nets, tally);
    CHECK(tally.complete == 1);
    closed += intersect(nets.first(), nets.second()).graph.count(ComponentShape::closed);
  }
  CHECK(closed >= 6);
}

TEST_CASE("intersect rational: neighbours that share a side or a corner meet there only") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    // A sheet over [0,2] x [0,2], 7 x 7 points of it, in four patches.
    const auto height = [&] { return Rational(random_pairs::integer(generator, -8, 8), 64); };
    std::vector<std::vector<Point>> sheet(7);
    for (int i = 0; i < 7; ++i)
      for (int j = 0; j < 7; ++j)
        sheet[static_cast<std::size_t>(i)].push_back({Rational(i, 3), Rational(j, 3), height()});
    const auto patch = [&](std::size_t a, std::size_t b) {
      Net net;
      for (std::size_t i = 0; i < 4; ++i)
        net.emplace_back(sheet[3 * a + i].begin() + static_cast<std::ptrdiff_t>(3 * b),
                         sheet[3 * a + i].begin() + static_cast<std::ptrdiff_t>(3 * b + 4));
      return RationalPatch(net);
    };
    const IntersectResult side = intersect(patch(0, 0), patch(1, 0));
    REQUIRE(side.status == Status::complete);
    REQUIRE(side.graph.arcs.size() == 1);
    CHECK(side.graph.arcs[0].place == ArcPlace::patch_boundary);
    CHECK(side.graph.arcs[0].contact == Contact::transversal);
    CHECK(side.graph.nodes.size() == 2);
    check_vertices(patch(0, 0), patch(1, 0), side.graph);
    const IntersectResult reversed =
        intersect(patch(0, 0), patch(1, 0).restricted_to(0, 1, 1, 0).transposed());
    CHECK(difference(side.graph, reversed.graph, {{0, 1, 3, 2}, {false, false, false, true}}) == "");
    const IntersectResult corner = intersect(patch(0, 0), patch(1, 1));
    REQUIRE(corner.status == Status::complete);
    CHECK(corner.graph.isolated_points.size() == 1);
    CHECK(corner.graph.arcs.empty());
  }
}

TEST_CASE("intersect rational: patches touch, or branches cross, in a rational point") {
  const Rational half(1, 2);
  for (const int sign : {1, -1}) {
    const IntersectResult result = graph_and_plane(sign, half);
    REQUIRE(result.status == Status::complete);
    const std::vector<NodeKind> kinds = {sign > 0 ? NodeKind::touch : NodeKind::crossing};
    CHECK(std::count_if(result.graph.nodes.begin(), result.graph.nodes.end(), [&](const Node& node) {
            return node.kinds == kinds && node.box[0].lower == half && node.box[0].upper == half;
          }) == 1);
    CHECK(result.graph.isolated_points.size() == (sign > 0 ? 1 : 0));
    CHECK(result.graph.count(ComponentShape::branched) == (sign > 0 ? 0 : 1));
  }
}

TEST_CASE("intersect rational: a plane that begins where the patches touch, and where branches cross") {
  const IntersectResult touch = graph_and_plane(1, 0);
  REQUIRE(touch.status == Status::complete);
  CHECK(touch.graph.isolated_points.size() == 1);
  CHECK(touch.graph.boundary_points() == 1);
  const IntersectResult crossing = graph_and_plane(-1, 0);
  REQUIRE(crossing.status == Status::complete);
  CHECK(crossing.graph.arcs.size() == 2);
  const Rational half(1, 2);
  const auto centre =
      std::find_if(crossing.graph.nodes.begin(), crossing.graph.nodes.end(), [&](const Node& node) {
        return node.on == std::vector<Side>{{Parameter::r, 0}} && node.box[0].lower <= half &&
               half <= node.box[0].upper;
      });
  REQUIRE(centre != crossing.graph.nodes.end());
  for (const Arc& arc : crossing.graph.arcs) CHECK((arc.from == centre->id || arc.to == centre->id));
}

TEST_CASE("intersect rational: a plane touches a bicubic graph along a line") {
  // a^2 + a^3 = 0 on u = 1/2 alone.
  const IntersectResult result = graph_and_plane(0, Rational(1, 2));
  REQUIRE(result.status == Status::complete);
  REQUIRE(result.graph.arcs.size() == 1);
  CHECK(result.graph.arcs[0].contact == Contact::tangential);
  CHECK(result.graph.nodes.size() == 2);
}

TEST_CASE("intersect rational: contact along a curve that is no line of the parameters") {
  const IntersectResult result = contact_along_diagonal(0);
  REQUIRE(result.status == Status::complete);
  REQUIRE(result.graph.arcs.size() == 1);
  CHECK(result.graph.arcs[0].contact == Contact::tangential);
}

TEST_CASE("intersect rational: what nothing decides is incomplete, with its place") {
  // Over quadrilaterals without parallel sides no patch has an inverse.
  const IntersectResult result = contact_along_diagonal(Rational(1, 4));
  REQUIRE(result.status == Status::incomplete);
  REQUIRE_FALSE(result.incomplete.empty());
  CHECK(result.incomplete[0].where[0].lower <= result.incomplete[0].where[1].upper);
  CHECK(result.incomplete[0].where[0].upper >= result.incomplete[0].where[1].lower);
  CHECK(result.graph.nodes.empty());
}

TEST_CASE("intersect rational: a curve that ends on sides of both patches") {
  Net sheet(4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      sheet[static_cast<std::size_t>(i)].push_back(
          {Rational(i, 3), Rational(j, 3), i == 0 ? Rational(0) : Rational(i * i - j, 20)});
  const Rational third(1, 3);
  const Rational half(1, 2);
  const Net wall = {{{0, third, -half}, {1, Rational(2, 5), -half}}, {{0, third, half}, {1, half, half}}};
  const IntersectResult result = intersect(RationalPatch(sheet), RationalPatch(wall));
  REQUIRE(result.status == Status::complete);
  CHECK(result.graph.count(ComponentShape::open) == 1);
  const auto is_end = [&](const Node& node) {
    return node.on == std::vector<Side>{{Parameter::u, 0}, {Parameter::s, 0}} && node.box[1].lower <= third &&
           node.box[1].upper >= third;
  };
  CHECK(std::count_if(result.graph.nodes.begin(), result.graph.nodes.end(), is_end) == 1);
}

TEST_CASE("intersect rational: biquadratic pairs take their own way") {
  Generator generator(3);
  const random_pairs::Pair pair = random_pairs::doubles(generator);
  const IntersectResult expected = intersect(pair.x, pair.y);
  const IntersectResult same = intersect(RationalPatch(pair.x).elevated(3, 3), RationalPatch(pair.y));
  CHECK(difference(expected.graph, same.graph, {}) == "");
}

TEST_CASE("intersect rational: a projective map of both patches keeps the graph") {
  const std::array<Degrees, 4> degrees = {{{2, 2, 2, 2}, {3, 3, 3, 3}, {1, 2, 2, 1}, {3, 2, 1, 3}}};
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= 32; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Nets nets = seed % 3 == 0 ? random_nets::loop(generator, degrees[seed % 4])
                                    : random_nets::crossing(generator, degrees[seed % 4], seed % 2 == 0);
    const IntersectResult expected = intersect(nets.first(), nets.second());
    const auto map = projective_map(generator);
    const RationalPatch x = image(nets.first(), map);
    const RationalPatch y = image(nets.second(), map);
    REQUIRE_FALSE(x.is_polynomial());
    const IntersectResult result = intersect(x, y);
    if (result.status != Status::complete || expected.status != Status::complete) continue;
    ++complete;
    CHECK(difference(expected.graph, result.graph, {}) == "");
    check_vertices(x, y, result.graph);
  }
  CHECK(complete >= 30);
}

TEST_CASE("intersect rational: turning points of a parameter that is nearly still") {
  // Doubles leave 2^-26 around them, or more; exact directions decide.
  Generator generator(171);
  const Nets nets = random_nets::scattered(generator, {3, 3, 3, 3});
  const IntersectResult result = intersect(nets.first(), nets.second());
  REQUIRE(result.status == Status::complete);
  const IntersectResult turned = intersect(nets.second(), nets.first().transposed());
  REQUIRE(turned.status == Status::complete);
  CHECK(difference(result.graph, turned.graph, {{3, 2, 0, 1}, {}}) == "");
  CHECK(result.graph.turning_points(Parameter::r) > 0);
  check_vertices(nets.first(), nets.second(), result.graph);
}

TEST_CASE("intersect rational: weights are homogeneous, and a parameter may be changed projectively") {
  int complete = 0;
  int others = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Nets nets =
        random_nets::crossing(generator, seed % 2 == 0 ? Degrees{2, 2, 2, 1} : Degrees{3, 3, 2, 3}, true);
    const RationalPatch x = random_nets::weighted(generator, nets.x);
    const RationalPatch y = random_nets::weighted(generator, nets.y);
    const IntersectResult expected = intersect(x, y);
    if (expected.status != Status::complete) continue;
    ++complete;
    check_vertices(x, y, expected.graph);
    const auto scale = [](const RationalPatch& p, const Rational& by) {
      return image(p, {{{by, 0, 0, 0}, {0, by, 0, 0}, {0, 0, by, 0}, {0, 0, 0, by}}});
    };
    const auto agrees = [&](const IntersectResult& other, const Renaming& renaming) {
      if (other.status == Status::complete) {
        ++others;
        CHECK(difference(expected.graph, other.graph, renaming) == "");
      }
    };
    agrees(intersect(scale(x, Rational(1, 3)), scale(y, 1000)), {});
    agrees(intersect(y, x), {{2, 3, 0, 1}, {}});
    agrees(intersect(x.elevated(3, 3), y.elevated(3, 3)), {});
    const IntersectResult changed = intersect(reparametrised(x, 2), y);
    if (changed.status != Status::complete) continue;
    ++others;
    CHECK(changed.graph.count(ComponentShape::closed) == expected.graph.count(ComponentShape::closed));
    CHECK(changed.graph.count(ComponentShape::open) == expected.graph.count(ComponentShape::open));
    for (const Parameter p : all_parameters)
      CHECK(changed.graph.turning_points(p) == expected.graph.turning_points(p));
  }
  CHECK(complete >= 15);
  CHECK(others >= 60);  // of 64
}

TEST_CASE("intersect rational: a quarter of a cylinder and a plane meet in an ellipse") {
  // x^2 + y^2 = 1, 0 <= z <= 2, weights 1, 1, 2, and z = x/2 + y/3 + 1/3 over a turned square.
  const RationalPatch cylinder({{{1, 0, 0}, {1, 0, 2}}, {{1, 1, 0}, {1, 1, 2}}, {{0, 1, 0}, {0, 1, 2}}},
                               {{1, 1}, {1, 1}, {2, 2}});
  const Rational third(1, 3);
  const auto on_plane = [&](long x, long y) { return Point{x, y, Rational(x, 2) + Rational(y, 3) + third}; };
  const RationalPatch plane({{on_plane(-2, -1), on_plane(0, 3)}, {on_plane(1, -2), on_plane(3, 2)}});
  const IntersectResult result = intersect(cylinder, plane);
  REQUIRE(result.status == Status::complete);
  CHECK(result.graph.count(ComponentShape::open) == 1);
  CHECK(result.graph.components.size() == 1);
  for (const Arc& arc : result.graph.arcs) {
    for (const PolylineVertex& vertex : arc.polyline) {
      const auto& p = vertex.point;
      CHECK(std::abs(p[0] * p[0] + p[1] * p[1] - 1) <= 2 * arc.error_bound + 1e-12);
      CHECK(std::abs(p[0] / 2 + p[1] / 3 + 1.0 / 3 - p[2]) <= 2 * arc.error_bound + 1e-12);
    }
  }
}

}  // namespace exsect::intersect_rational_test
