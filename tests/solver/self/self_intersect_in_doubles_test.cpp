// Patches of every kind against themselves: biquadratic ones have the answer of the exact solution, as they
// are and as images under projective maps; known loops; maps of the parameters.
#include "self/self_intersect_in_doubles.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>

#include "support/catch.h"
#include "support/polynomial_patch.h"
#include "support/random_nets.h"
#include "support/random_pairs.h"
#include "support/self_orders.h"

namespace exsect::self_intersect_in_doubles_test {
namespace {

using random_pairs::Generator;
using testing::in_both_orders;

BezierPatch scattered(Generator& generator) {
  ControlNet net;
  for (auto& row : net)
    for (Point& p : row)
      for (Rational& c : p) c = random_pairs::integer(generator, -1000, 1000);
  return BezierPatch(net);
}

BezierPatch doubles(Generator& generator) {
  ControlNet net;
  for (auto& row : net)
    for (Point& p : row)
      for (Rational& c : p) c = from_double(static_cast<double>(generator() >> 11U) * 0x1p-53);
  return BezierPatch(net);
}

/// Not by the exact way, whatever the patch.
IntersectResult in_doubles(const RationalPatch& x) {
  return in_nearest_rounding([&] {
    const Run run;
    return run.finished(self_intersect_in_doubles(x, run));
  });
}

void check_complete(const IntersectResult& result) {
  for (const Incomplete& open : result.incomplete) UNSCOPED_INFO(open.why);
  REQUIRE(result.status == Status::complete);
}

void check_same(const IntersectResult& result, const IntersectionGraph& expected,
                const Renaming& renaming = {}) {
  check_complete(result);
  CHECK(difference(in_both_orders(expected), in_both_orders(result.graph), renaming) == "");
}

/// (0,0), (3,2), (-2,2), (1,0), which crosses itself once.
constexpr std::array<std::array<int, 2>, 4> kLoop = {{{0, 0}, {3, 2}, {-2, 2}, {1, 0}}};

/// The loop moved along a curve that bends in three directions, and widened on its way by `growth` sixths.
RationalPatch swept_loop(int degree, int growth) {
  std::vector<std::vector<Point>> net(4);
  for (std::size_t i = 0; i < 4; ++i)
    for (int j = 0; j <= degree; ++j) {
      const Rational scale = 1 + Rational(growth * j, 6);
      net[i].push_back(
          {scale * kLoop[i][0] + Rational(j * j, 5), scale * kLoop[i][1] - Rational(j, 7), Rational(2 * j)});
    }
  return RationalPatch(net);
}

/// A plane loop from (0,0) to (0,0) moved along a curve, with an edge where it closes: the side u = 1 is the
/// side u = 0, or this one in the other direction. Inner control points are moved at random.
RationalPatch closed_band(Generator& generator, int degree, bool weighted, bool twisted) {
  constexpr std::array<std::array<int, 2>, 4> loop = {{{0, 0}, {6, 0}, {0, 6}, {0, 0}}};
  const auto random = [&] { return Rational(random_pairs::integer(generator, -4, 4), 8); };
  random_nets::Net net(4);
  random_nets::Weights weights(4);
  for (std::size_t i = 0; i < 3; ++i)
    for (int j = 0; j <= degree; ++j) {
      const Rational a = loop[i][0] + random(), b = loop[i][1] + random();
      net[i].push_back({a, b, 4 * j - 2 * degree + random()});
      weights[i].push_back(weighted ? 1 + random() / 2 : Rational(1));
    }
  net[3] = net[0];
  weights[3] = weights[0];
  if (twisted) {
    std::ranges::reverse(net[3]);
    std::ranges::reverse(weights[3]);
  }
  return RationalPatch(net, weights);
}

/// One arc on sides, all along u1 = 0 and u2 = 1, or the other way round.
void check_seam(const IntersectionGraph& graph, bool twisted) {
  const auto on_sides = [](const Arc& arc) { return arc.place == ArcPlace::patch_boundary; };
  REQUIRE(std::ranges::count_if(graph.arcs, on_sides) == 1);
  CHECK((twisted || graph.arcs.size() == 1));
  CHECK(graph.isolated_points.empty());
  const Arc& arc = *std::ranges::find_if(graph.arcs, on_sides);
  for (const int end : {arc.from, arc.to})
    CHECK(graph.nodes.at(static_cast<std::size_t>(end)).on.size() == 4);
  for (const PolylineVertex& vertex : arc.polyline) {
    const auto& at = vertex.parameters;
    CHECK(at[0] + at[2] == 1);
    CHECK(at[0] * at[2] == 0);
    CHECK(std::fabs((twisted ? 1 - at[1] : at[1]) - at[3]) < 1e-9);
  }
}

/// Two sheets that touch in x(a,1/2) = x(b,1/2) = (0,0,0), from the two sides of z = 0: a plane loop, z = 0,
/// moved along with v on both sides of v = 1/2, where z = (v - 1/2)^2 ((a + b)/2 - u).
RationalPatch touching_sheets(const Rational& a, const Rational& b) {
  const Rational middle = (a + b) / 2, half(1, 2);
  random_nets::Net net(4, std::vector<Point>(3));
  const auto at = [&](const Rational& u, const Rational& v) {
    const Rational loop = (u - a) * (u - b), h = v - half;
    return Point{loop + h / 5, 4 * loop * (u - middle) + h, h * h * (middle - u)};
  };
  // Bernstein coefficients of degree 3 and 2 from values.
  const auto cubic = [](const std::array<Point, 4>& p) {
    const Rational sixth(1, 6);
    return std::array<Point, 4>{
        p[0], sixth * (Rational(-5) * p[0] + Rational(18) * p[1] - Rational(9) * p[2] + Rational(2) * p[3]),
        sixth * (Rational(2) * p[0] - Rational(9) * p[1] + Rational(18) * p[2] - Rational(5) * p[3]), p[3]};
  };
  for (int j = 0; j < 3; ++j) {
    std::array<Point, 4> values;
    for (int i = 0; i < 4; ++i) values[static_cast<std::size_t>(i)] = at(Rational(i, 3), Rational(j, 2));
    const auto column = cubic(values);
    for (std::size_t i = 0; i < 4; ++i) net[i][static_cast<std::size_t>(j)] = column[i];
  }
  for (auto& row : net) row[1] = 2 * row[1] - half * (row[0] + row[2]);
  return RationalPatch(net);
}

/// Whitney's umbrella (a^2, a b, b) with a = v - 1/2, b = u - c a^2: its pairs are 1/2 + a and 1/2 - a at
/// u = c a^2, and on the side u = 0 it has a cusp.
RationalPatch umbrella_on_side(const Rational& c) {
  const BivariatePolynomial a = BivariatePolynomial::s() - BivariatePolynomial::constant(Rational(1, 2)),
                            b = BivariatePolynomial::r() - BivariatePolynomial::constant(c) * a * a;
  return testing::patch_of({a * a, a * b, b});
}

}  // namespace

TEST_CASE("self in doubles: random biquadratic patches as the exact solution has them") {
  for (std::uint64_t seed = 2; seed <= 7; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const BezierPatch x = scattered(generator);
    check_same(in_doubles(x), self_intersect(x).graph);
  }
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    INFO("53 bits, seed " << seed);
    Generator generator(seed);
    const BezierPatch x = doubles(generator);
    check_same(in_doubles(x), self_intersect(x).graph);
  }
}

TEST_CASE(
    "self in doubles: images under projective maps, and other parameters, meet themselves in the same "
    "pairs") {
  Generator generator(20);
  const BezierPatch x = doubles(generator);
  const IntersectionGraph expected = self_intersect(x).graph;
  REQUIRE_FALSE(expected.arcs.empty());
  check_same(self_intersect(random_nets::image(x, random_nets::projective_map(generator))), expected);
  check_same(in_doubles(x.exchanged()), expected, {{1, 0, 3, 2}, {}});
}

TEST_CASE("self in doubles: a loop that is swept crosses itself along one curve") {
  for (const int growth : {0, 1})
    for (const int degree : {1, 2, 3}) {
      INFO("degree " << degree << ", growth " << growth);
      const IntersectResult result = self_intersect(swept_loop(degree, growth));
      check_complete(result);
      CHECK(result.graph.count(ComponentShape::open) == 1);
      CHECK(result.graph.components.size() == 1);
      CHECK(result.graph.boundary_points() == 2);
      // The double point of the loop is at t = 1/2 -+ sqrt(3)/4.
      for (const Arc& arc : result.graph.arcs)
        for (const PolylineVertex& vertex : arc.polyline) {
          const auto [least, most] = std::minmax(vertex.parameters[0], vertex.parameters[2]);
          CHECK(std::fabs(least + most - 1) < 1e-9);
          CHECK(std::fabs(vertex.parameters[1] - vertex.parameters[3]) < 1e-9);
        }
    }
}

TEST_CASE("self in doubles: a swept loop under a projective map has the same curve") {
  Generator generator(3);
  const RationalPatch x = swept_loop(2, 1);
  const RationalPatch image = random_nets::image(x, random_nets::projective_map(generator));
  REQUIRE_FALSE(image.is_polynomial());
  check_same(self_intersect(image), self_intersect(x).graph);
}

TEST_CASE("self in doubles: closed bands meet themselves along the sides where they close") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const bool twisted : {false, true})
      for (const bool weighted : {false, true}) {
        Generator generator(seed);
        const int degree = twisted ? 1 : 1 + static_cast<int>(seed % 3);
        INFO("seed " << seed << ", twisted " << twisted << ", weighted " << weighted);
        const RationalPatch x = closed_band(generator, degree, weighted, twisted);
        const IntersectResult result = self_intersect(x);
        check_complete(result);
        check_seam(result.graph, twisted);
        check_same(self_intersect(x.transposed()), result.graph, {{1, 0, 3, 2}, {}});
      }
}

TEST_CASE("self in doubles: a band that closes after a turn of half its length") {
  // x = (loop(u), v + u/2): x(0,v + 1/2) = x(1,v).
  constexpr std::array<std::array<int, 2>, 4> loop = {{{0, 0}, {3, 0}, {0, 3}, {0, 0}}};
  random_nets::Net net(4);
  for (std::size_t i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) net[i].push_back({loop[i][0], loop[i][1], 6 * j + static_cast<int>(i)});
  const IntersectResult result = self_intersect(RationalPatch(net));
  check_complete(result);
  REQUIRE(result.graph.arcs.size() == 1);
  for (const PolylineVertex& vertex : result.graph.arcs[0].polyline) {
    const auto& at = vertex.parameters;
    CHECK(std::fabs(std::fabs(at[1] - at[3]) - 0.5) < 1e-12);
    CHECK(at[0] + at[2] == 1);
  }
}

TEST_CASE(
    "self in doubles: biquadratic patches with a side that is one point as the exact solution has them") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    ControlNet net = scattered(generator).net();
    const Point pole = scattered(generator).net()[0][0];
    const std::size_t side = seed % 4 < 2 ? 0 : 2;
    for (std::size_t k = 0; k < 3; ++k) (seed % 2 == 0 ? net[side][k] : net[k][side]) = pole;
    const BezierPatch x(net);
    check_same(in_doubles(x), self_intersect(x).graph);
  }
}

TEST_CASE("self in doubles: parts of a sphere and of cones, up to their poles") {
  // From pole to pole, a quarter around; an eighth of it; a cone over a quarter of a circle.
  random_nets::Net lune(4), octant(3), cone(2);
  random_nets::Weights lune_weights(4), octant_weights(3), cone_weights(2);
  constexpr std::array<std::array<int, 2>, 3> around = {{{1, 0}, {1, 1}, {0, 1}}};
  constexpr std::array<int, 3> around_weights = {1, 1, 2};
  const auto append = [&](random_nets::Net& net, random_nets::Weights& weights, std::size_t i, int radius,
                          int height, const Rational& weight) {
    for (std::size_t j = 0; j < 3; ++j) {
      net[i].push_back({radius * around[j][0], radius * around[j][1], height});
      weights[i].push_back(weight * around_weights[j]);
    }
  };
  for (std::size_t i = 0; i < 4; ++i)
    append(lune, lune_weights, i, i % 3 == 0 ? 0 : 2, i < 2 ? -1 : 1, i % 3 == 0 ? 3 : 1);
  append(octant, octant_weights, 0, 1, 0, 1);
  append(octant, octant_weights, 1, 1, 1, 1);
  append(octant, octant_weights, 2, 0, 1, 2);
  append(cone, cone_weights, 0, 0, 0, 1);
  append(cone, cone_weights, 1, 1, 1, 1);
  Generator generator(5);
  for (const auto& [x, poles] : {std::pair(RationalPatch(lune, lune_weights), 2U),
                                 std::pair(RationalPatch(octant, octant_weights), 1U),
                                 std::pair(RationalPatch(cone, cone_weights), 1U)})
    for (const RationalPatch& image : {x, x.transposed(), x.restricted_to(1, 0, 1, 0),
                                       random_nets::image(x, random_nets::projective_map(generator))}) {
      const IntersectResult result = self_intersect(image);
      check_complete(result);
      CHECK(result.graph.arcs.empty());
      CHECK(result.graph.nodes.size() == poles);
      CHECK(result.graph.isolated_points.size() == poles);
    }
}

TEST_CASE("self in doubles: a cone over a closed loop meets itself along a line from its apex") {
  const Point apex = {0, 0, 0};
  const RationalPatch x({{apex, apex, apex, apex}, {{-1, -1, 2}, {2, -1, 2}, {-1, 2, 2}, {-1, -1, 2}}});
  const IntersectResult result = self_intersect(x);
  check_complete(result);
  REQUIRE(result.graph.arcs.size() == 1);
  CHECK(result.graph.isolated_points.empty());
  const Arc& arc = result.graph.arcs[0];
  for (const PolylineVertex& vertex : arc.polyline) {
    CHECK(vertex.parameters[1] + vertex.parameters[3] == 1);
    CHECK(std::fabs(vertex.parameters[0] - vertex.parameters[2]) < 1e-12);
  }
  check_same(self_intersect(x.transposed()), result.graph, {{1, 0, 3, 2}, {}});
}

TEST_CASE("self in doubles: sheets that touch in a rational point") {
  for (const auto& [a, b] :
       {std::pair(Rational(1, 4), Rational(3, 4)), std::pair(Rational(1, 8), Rational(3, 4)),
        std::pair(Rational(2, 7), Rational(9, 11))}) {
    INFO("a = " << a << ", b = " << b);
    const RationalPatch x = touching_sheets(a, b);
    REQUIRE(x(a, Rational(1, 2)) == x(b, Rational(1, 2)));
    const IntersectResult result = self_intersect(x);
    check_complete(result);
    REQUIRE(result.graph.isolated_points.size() == 1);
    const Node& node = result.graph.nodes.at(static_cast<std::size_t>(result.graph.isolated_points[0]));
    CHECK(node.kinds == std::vector<NodeKind>{NodeKind::touch});
    const RationalInterval u1 =
        std::min(node.box[0], node.box[2], [](const auto& s, const auto& t) { return s.lower < t.lower; });
    CHECK(u1.lower <= a);
    CHECK(u1.upper >= a);
    // The other curve is the same from pinch point to pinch point whichever turning points are asked for.
    CHECK(result.graph.count(ComponentShape::open) == 1);
    CHECK(result.graph.components.size() == 1);
  }
}

TEST_CASE("self in doubles: patches that are injective, of every kind") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_nets::Nets nets = random_nets::crossing(generator, {3, 2, 3, 3}, true);
    for (const RationalPatch& x : {nets.first(), nets.second(), random_nets::weighted(generator, nets.x)}) {
      const IntersectResult result = self_intersect(x);
      check_complete(result);
      CHECK(result.graph.nodes.empty());
    }
  }
}

TEST_CASE("self in doubles: a patch that covers its image twice is said to") {
  random_nets::Net net(4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j)
      net[static_cast<std::size_t>(i)].push_back({i * (3 - i), j, i * (3 - i) * j + j});
  const IntersectResult result = self_intersect(RationalPatch(net, {{1, 2}, {2, 1}, {2, 1}, {1, 2}}));
  CHECK(result.status == Status::incomplete);
  REQUIRE(result.incomplete.size() == 1);
  CHECK(result.incomplete[0].why ==
        "the patch covers its image more than once: (u, v) and (1 - u, v) are one point; its other pairs are "
        "not "
        "decided");
}

TEST_CASE("self in doubles: what is not decided is incomplete, and exact needs a biquadratic patch") {
  const RationalPatch loop = swept_loop(2, 0);
  IntersectOptions options;
  options.exact = true;
  CHECK_THROWS_AS(self_intersect(loop, options), NotSupported);
  // A cubic with a cusp, swept: not even the cuspidal line is a pinch point.
  const RationalPatch cuspidal(
      {{{0, 0, 0}, {0, 0, 1}}, {{1, 1, 0}, {1, 1, 1}}, {{0, 1, 0}, {0, 1, 1}}, {{1, 0, 0}, {1, 0, 1}}});
  const IntersectResult result = self_intersect(cuspidal);
  CHECK(result.status == Status::incomplete);
  CHECK(result.graph.nodes.empty());
  CHECK_FALSE(result.incomplete.empty());
}

TEST_CASE("self in doubles: a pinch point on a side, along which its kernel lies") {
  Generator generator(20261127);
  for (const Rational& c : {Rational(1), Rational(3, 7), Rational(-1), Rational(-2, 5)}) {
    CAPTURE(c.str());
    const RationalPatch x = umbrella_on_side(c);
    const IntersectResult result = in_doubles(x);
    check_complete(result);
    REQUIRE(result.graph.arcs.size() == (c > 0 ? 1U : 0U));
    CHECK(result.graph.nodes.size() == 2 * result.graph.arcs.size());
    for (const Node& node : result.graph.nodes) {
      const bool is_cusp = node.kinds == std::vector{NodeKind::cusp, NodeKind::boundary};
      REQUIRE(node.on.size() == 2);
      if (is_cusp) {
        CHECK(node.on == std::vector<Side>{{Parameter::u, 0}, {Parameter::r, 0}});
        CHECK((node.box[1].lower <= Rational(1, 2) && node.box[1].upper >= Rational(1, 2)));
        CHECK(node.approx[1] == 0.5);
      } else {
        CHECK((node.box[0].lower <= c / 4 && node.box[0].upper >= c / 4));
        CHECK(node.approx[1] + node.approx[3] == 1);
      }
    }
    for (const Arc& arc : result.graph.arcs)
      for (const PolylineVertex& vertex : arc.polyline) {
        const auto& at = vertex.parameters;
        CHECK(std::fabs(at[0] - at[2]) < 1e-7);
        CHECK(std::fabs(at[0] - to_double(c) * (at[1] - 0.5) * (at[1] - 0.5)) < 1e-7);
      }
    // The curve of x itself is straight, its polyline coarse in the parameters.
    const RationalPatch y = random_nets::image(x, random_nets::projective_map(generator));
    const IntersectResult bent = in_doubles(y);
    check_complete(bent);
    CHECK(bent.graph.nodes.size() == result.graph.nodes.size());
    check_same(in_doubles(random_nets::image(x, random_nets::projective_map(generator))), bent.graph);
    check_same(in_doubles(y.transposed()), bent.graph, {{1, 0, 3, 2}, {}});
    check_same(in_doubles(y.restricted_to(1, 0, 0, 1).elevated(3, 3)), bent.graph,
               {{0, 1, 2, 3}, {true, false, true, false}});
  }
}

TEST_CASE("self in doubles: a straight side that turns back on itself, up to a Moebius map") {
  Generator generator(20261130);
  for (const Rational& k : {Rational(1), Rational(3), Rational(2, 5)}) {
    CAPTURE(k.str());
    const RationalPatch x = random_nets::reparametrised(umbrella_on_side(0).transposed(), k).transposed();
    const IntersectResult result = in_doubles(x);
    check_complete(result);
    REQUIRE(result.graph.arcs.size() == 1);
    REQUIRE(result.graph.nodes.size() == 2);
    const Arc& arc = result.graph.arcs[0];
    CHECK(arc.place == ArcPlace::patch_boundary);
    CHECK(arc.contact == Contact::transversal);
    CHECK(std::ranges::count(result.graph.nodes, std::vector{NodeKind::cusp, NodeKind::boundary},
                             &Node::kinds) == 1);
    const double ratio = to_double(k);
    for (const PolylineVertex& vertex : arc.polyline) {
      const auto& at = vertex.parameters;
      CHECK(at[0] == 0);
      CHECK(at[2] == 0);
      const auto before = [&](double t) { return t / (ratio * (1 - t) + t); };
      CHECK(std::fabs(before(at[1]) + before(at[3]) - 1) < 1e-7);
    }
    const RationalPatch y = random_nets::image(x, random_nets::projective_map(generator));
    check_same(in_doubles(y), result.graph);
    check_same(in_doubles(y.transposed()), result.graph, {{1, 0, 3, 2}, {}});
    check_same(in_doubles(y.restricted_to(1, 0, 0, 1)), result.graph,
               {{0, 1, 2, 3}, {true, false, true, false}});
  }
}

TEST_CASE("self in doubles: a pinch point of a mirror image of itself, with its kernel along v") {
  // Pairs 1/2 + a, 1/2 - a at u^2 + u = 1 + a^2.
  const BivariatePolynomial u = BivariatePolynomial::r(), one = BivariatePolynomial::constant(1),
                            a = BivariatePolynomial::s() - BivariatePolynomial::constant(Rational(1, 2));
  const RationalPatch x = testing::patch_of({a * (u * u + u - one - a * a), a * a + u, u * u});
  const IntersectResult result = in_doubles(x);
  check_complete(result);
  REQUIRE(result.graph.arcs.size() == 1);
  REQUIRE(result.graph.nodes.size() == 2);
  CHECK(std::ranges::count(result.graph.nodes, std::vector{NodeKind::cusp}, &Node::kinds) == 1);
  for (const PolylineVertex& vertex : result.graph.arcs[0].polyline) {
    const auto& at = vertex.parameters;
    CHECK(std::fabs(at[0] - at[2]) < 1e-7);
    CHECK(std::fabs(at[1] + at[3] - 1) < 1e-7);
    CHECK(std::fabs(at[0] * at[0] + at[0] - 1 - (at[1] - 0.5) * (at[1] - 0.5)) < 1e-6);
  }
  Generator generator(20261129);
  check_same(in_doubles(random_nets::image(x, random_nets::projective_map(generator))), result.graph);
  check_same(in_doubles(x.transposed()), result.graph, {{1, 0, 3, 2}, {}});
}

TEST_CASE("self in doubles: irrational touch points of two sheets") {
  // As touching_sheets() with a + b = 1, a b = 1/8.
  const auto number = [](const Rational& c) { return BivariatePolynomial::constant(c); };
  const BivariatePolynomial u = BivariatePolynomial::r(),
                            h = BivariatePolynomial::s() - number(Rational(1, 2)),
                            loop = u * u - u + number(Rational(1, 8)), t = u - number(Rational(1, 2));
  const IntersectResult result = in_doubles(testing::patch_of(
      {loop + number(Rational(1, 5)) * h, number(4) * loop * t + h, number(-1) * h * h * t}));
  check_complete(result);
  REQUIRE(result.graph.isolated_points.size() == 1);
  const Node& node = result.graph.nodes.at(static_cast<std::size_t>(result.graph.isolated_points[0]));
  CHECK(node.kinds == std::vector{NodeKind::touch});
  for (const std::size_t j : {0U, 2U})
    CHECK(std::fabs(std::fabs(node.approx[j] - 0.5) - std::sqrt(0.125)) < 1e-12);
}

TEST_CASE("self in doubles: pinch points in corners, with their kernels along sides and across them") {
  Generator generator(20261128);
  for (int round = 0; round < 4; ++round) {
    CAPTURE(round);
    ControlNet net = scattered(generator).net();
    const Point& corner = net[0][2];
    if (round % 2 == 0) {
      net[1][2] = corner;
    } else {  // x_u and x_v are parallel
      net[1][2] = corner + Rational(round == 1 ? -2 : 2, 3) * (net[0][1] - corner);
    }
    const BezierPatch x(net);
    const IntersectResult exact = self_intersect(x);
    check_complete(exact);
    check_same(in_doubles(x), exact.graph);
  }
}

}  // namespace exsect::self_intersect_in_doubles_test
