#include "self/star.h"

#include <algorithm>
#include <initializer_list>
#include <random>
#include <vector>

#include "answer/exact_source.h"
#include "answer/parameter_box.h"
#include "self/pairs.h"
#include "self/singular_pairs.h"
#include "self/turning.h"
#include "self/turning_pairs.h"
#include "support/catch.h"
#include "support/self_checks.h"

namespace exsect::star_test {
using exsect::testing::checked;
using exsect::testing::degrees;
using exsect::testing::patch;
using exsect::testing::random_patch;
using exsect::testing::self_fibre;
using exsect::testing::self_locus;

namespace {

// The side u = 1 turns at v = 2/3; both tangent planes agree at v = 1 and v = 1/3.
const std::vector<int> kFoldedSide = {1, 1, 0, -1, 1, -1, -1, 0, -1, 1, -1, 1, -1, -1,
                                      0, 1, 1, 1,  1, -1, -1, 1, 1,  1, 1,  0, 0};
// Another curve crosses the pairs of the folded line u = 1/2.
const std::vector<int> kCrossedFold = {-1, 1,  1,  -1, 1,  -1, 0, 0,  -1, 0, -1, -1, 1, 1,
                                       -1, -1, -1, 1,  -1, 1,  0, -1, -1, 0, -1, 1,  -1};
// x_v = 0 in the corner (1,1), and the patch does not meet itself there.
const std::vector<int> kCuspidalCorner = {1, -1, -1, 0, 1, 1,  0, 1, 1,  -1, 0, 0,  0, 1,
                                          0, 0,  -1, 0, 0, -1, 0, 0, -1, -1, 0, -1, 1};
// The same in the corner (1,0), and the side u = 0 is one point.
const std::vector<int> kCornerAndPoint = {-1, 0, 0,  -1, 0, 0, -1, 0, 0, 0, 1, 1, 1, -1,
                                          -1, 1, -1, -1, 1, 1, 0,  1, 1, 0, 0, 1, 1};
// x_u = 0 in the corner (0,0), in which a curve ends.
const std::vector<int> kCurveToCorner = {0, 1,  1, 0, 0, 0, -1, 1, 0, 0, 1, 1,  1, -1,
                                         1, -1, 1, 0, 0, 0, 0,  0, 0, 1, 0, -1, 1};

// The side v = 1 turns in a singular cuspidal point and ends where both tangent planes agree: known one after
// the other.
const std::vector<int> kTwiceSingular = {0, 1, -1, 0, 1,  2, 2,  2,  0,  -1, 1, -1, -2, 0,
                                         1, 0, 1,  2, -1, 1, -1, -2, -2, -2, 2, 2,  0};

// The sides u = 1 and v = 1 turn at 1/2, and both tangent planes agree along them: the lines next to it turn
// at 1/2 too; the tangent plane is constant.
const std::vector<int> kTouchingFold = {0, -1, -1, 0, 0, -1, 1, 1, 0, 0,  -1, 0, 1, 0,
                                        1, 0,  -1, 0, 1, 0,  1, 0, 1, -1, 1,  0, 1};
const std::vector<int> kPlanarFold = {0, 0,  -1, -1, 1,  0, 0,  1, 1, 1,  1, -1, 1, 1,
                                      0, -1, 1,  1,  -1, 0, -1, 1, 1, -1, 0, 1,  1};

// The line u = 2/3, and in the second one u = (3 - sqrt 5)/4, is folded, and another curve crosses it in an
// irrational pair.
const std::vector<int> kCrossedAtTwoThirds = {1, -1, -1, 1,  1,  1,  1, -1, -1, 1, 0, 0, 0, -1,
                                              1, 0,  -1, -1, -1, -1, 0, -1, 1,  1, 0, 0, 1};
const std::vector<int> kIrrationalFold = {0, 0,  0, -1, 0,  -1, 0, -1, -1, -1, -1, -1, 1, -1,
                                          0, -1, 1, 1,  -1, 0,  0, 0,  0,  -1, -1, 1,  1};

// The side u = 1 is folded, and both tangent planes agree along it; a curve is tangent to it at its end. A
// second search for stars takes seconds.
const std::vector<int> kFoldAndTangentCurve = {0,  -1, 0, 1, -1, -1, 1, 0,  1, -1, 0,  -1, 0, -1,
                                               -1, -1, 0, 0, -1, 0,  0, -1, 0, 1,  -1, 0,  -1};

// Two curves cross in a pair with irrational parameters, of degree 2 over Q.
const std::vector<int> kIrrationalCrossing = {0, 1, -1, 1,  0, 0, 0,  0,  0, 0, 0, 1, 1, 1,
                                              1, 0, 1,  -1, 0, 0, -1, -1, 1, 0, 1, 0, 0};

// The sides u = 0 and v = 1 are glued, x(0,t) = x(1 - t,1), up to their common corner; another curve crosses
// them.
const std::vector<int> kGluedAtCorner = {1,  1, 0,  1, -1, 1,  -1, 1,  1,  1,  -1, -1, 1, 1,
                                         -1, 1, -1, 1, 0,  -1, -1, -1, -1, -1, 1,  1,  0};
// v1 + v2 = 1 on a curve, so that v1 and v2 turn together, at a pair of degree 16 over Q.
const std::vector<int> kTurnTogether = {0, 1,  1,  1, -1, -1, 0, -1, -1, 0, -1, -1, 0, -1,
                                        0, -1, -1, 0, 1,  1,  0, 0,  -1, 0, 1,  0,  -1};

// The side u = 1 is straight, with one tangent plane all along: a curve that ends on it has T_v1 = 0 there,
// at an irrational pair, with v2 a square root over the field of the other parameters.
const std::vector<int> kTangentAtFoldedSide = {-1, -1, 1,  1, 1,  -1, -1, 1,  -1, 1, 1, 1,  -1, 1,
                                               1,  0,  -1, 0, -1, 1,  1,  -1, 1,  1, 0, -1, 0};

/// The line v = c turns at u = f, and both tangent planes agree along it, for one of the two reasons.
BezierPatch multiple_fold(std::mt19937& generator, bool planar, const Rational& f, const Rational& c) {
  std::uniform_int_distribution<int> coefficient(-2, 2);
  ControlNet d{};  // of (u - f)^i (v - c)^j
  for (auto& row : d)
    for (Point& p : row) p = {coefficient(generator), coefficient(generator), coefficient(generator)};
  const std::array<Rational, 3> k = {coefficient(generator), coefficient(generator), coefficient(generator)};
  d[1][0] = {0, 0, 0};
  if (planar) {
    d[0][1] = k[0] * d[2][0] + k[1] * d[1][1];
    d[2][1] = k[1] * d[2][0] + k[2] * d[1][1];
  } else {
    d[1][1] = k[0] * d[2][0];
  }
  return BezierPatch::from_power_basis(d).restricted_to(-f, 1 - f, -c, 1 - c);
}

}  // namespace

TEST_CASE("the minors give the resultant form of the self-intersection") {
  std::mt19937 generator(8);
  for (int i = 0; i < 5; ++i) {
    const BezierPatch x = random_patch(generator, 3);
    const BivariatePolynomial q = self_projection(x).curve;
    const BivariatePolynomial expected = self_locus(x);
    CHECK((q == expected || q == expected * Polynomial(-1)));
  }
  CHECK(self_projection(patch(kCrossedFold)).curve.degree_r() == 10);
}

TEST_CASE("between turning values the pairs on a line keep their number") {
  std::mt19937 generator(9);
  for (int i = 0; i < 3; ++i) {
    const BezierPatch x = random_patch(generator, 2);
    auto values = self_turning_values(x);
    REQUIRE(values);
    for (const std::size_t parameter : {0U, 1U})  // pairs with a point on a side
      for (const int side : {0, 1})
        for (const CertifiedPoint& point : self_fibre(x, parameter, side))
          for (const std::size_t j : {1U, 3U})
            values->push_back(point.refined_to(power_of_two(-60)).box()[j].midpoint());
    std::ranges::sort(*values, std::less<>());
    Rational last = 0;
    for (const RealAlgebraic& value : *values) {
      const Rational next = value.refined_to(power_of_two(-50)).interval().lower - power_of_two(-40);
      if (next > last) {
        INFO("net " << i << ", v from " << last << " to " << next);
        const Rational width = next - last;
        CHECK(self_fibre(x, 1, last + width / 7).size() == self_fibre(x, 1, next - width / 7).size());
      }
      last = value.refined_to(power_of_two(-50)).interval().upper + power_of_two(-40);
    }
  }
}

TEST_CASE("cuspidal values are those of all cuspidal points") {
  const auto values = cuspidal_values(patch(kCuspidalCorner));
  REQUIRE(values);
  CHECK(std::ranges::count(*values, RealAlgebraic(1)) == 1);
  // (u^2, u v, v) is cuspidal along no curve, (u^2, v, 0) along u = 0.
  const BezierPatch umbrella =
      patch({0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 1, 1, 0, 2, 2, 2, 0, 0, 2, 2, 1, 2, 4, 2});
  CHECK(cuspidal_values(umbrella)->size() == 1);
  const BezierPatch fold =
      patch({0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1, 0, 0, 1, 1, 0, 1, 2, 0});
  CHECK_FALSE(cuspidal_values(fold));
}

TEST_CASE("a folded side at the end of which both tangent planes agree") {
  const IntersectionGraph graph = checked(patch(kFoldedSide));
  CHECK(
      std::ranges::any_of(graph.arcs, [](const Arc& arc) { return arc.place == ArcPlace::patch_boundary; }));
}

TEST_CASE("a folded side between two singular pairs") {
  const IntersectionGraph graph = checked(patch(kTwiceSingular));
  CHECK(std::ranges::any_of(graph.arcs, [&](const Arc& arc) {
    return arc.place == ArcPlace::patch_boundary &&
           graph.nodes[static_cast<std::size_t>(arc.from)].on.size() +
                   graph.nodes[static_cast<std::size_t>(arc.to)].on.size() >=
               6;
  }));
}

TEST_CASE("stars that are found one after the other: sound at a work cap in between") {
  const BezierPatch x = patch(kFoldAndTangentCurve);
  IntersectOptions options;
  options.tolerance = 1e-3;
  for (const double seconds : {3.0, 6.0}) {
    CAPTURE(seconds);
    options.max_seconds = seconds;
    CHECK(unsound(x, x, self_intersect(x, options)) == "");
  }
}

TEST_CASE("folded sides along which both tangent planes agree") {
  for (const std::vector<int>& net : {kTouchingFold, kPlanarFold}) {
    const IntersectionGraph graph = checked(patch(net));
    const auto fold = std::ranges::find(graph.arcs, ArcPlace::patch_boundary, &Arc::place);
    REQUIRE(fold != graph.arcs.end());
    CHECK(fold->contact == Contact::tangential);
  }
}

TEST_CASE("folded lines inside along which both tangent planes agree") {
  const auto [planar, seed] =
      GENERATE(table<bool, unsigned>({{false, 1}, {false, 10}, {true, 4}, {true, 5}}));
  std::mt19937 generator(seed);
  INFO("seed " << seed);
  const IntersectionGraph graph = checked(multiple_fold(generator, planar, Rational(2, 3), Rational(1, 3)));
  CHECK(std::ranges::count(graph.arcs, Contact::tangential, &Arc::contact) == 1);
}

TEST_CASE("a folded line with one tangent plane, the lines near it turn on a line") {
  // (p^2, p h^2 + h, h^2), p = u - 2/3, h = v - 1/3: the same at (p,0) and (-p,0), and at no other two
  // points with |p h| < 1.
  ControlNet d{};
  d[2][0] = {1, 0, 0};
  d[1][2] = d[0][1] = {0, 1, 0};
  d[0][2] = {0, 0, 1};
  const BezierPatch x = BezierPatch::from_power_basis(d).restricted_to(Rational(-2, 3), Rational(1, 3),
                                                                       Rational(-1, 3), Rational(2, 3));
  const IntersectionGraph graph = checked(x);
  REQUIRE(graph.arcs.size() == 1);
  CHECK(graph.arcs[0].contact == Contact::tangential);
  CHECK(graph.isolated_points.empty());
  CHECK(degrees(graph, NodeKind::cusp) == std::vector{1});
  for (const PolylineVertex& vertex : graph.arcs[0].polyline) {
    const auto [u, v, r, s] = vertex.parameters;
    CHECK(u + r == Approx(4.0 / 3));
    CHECK(v == Approx(1.0 / 3));
    CHECK(s == Approx(1.0 / 3));
  }
}

TEST_CASE("a curve that crosses the pairs of a folded line") {
  const IntersectionGraph graph = checked(patch(kCrossedFold));
  CHECK(degrees(graph, NodeKind::crossing) == std::vector{4});
}

TEST_CASE("an irrational crossing on a folded line") {
  const auto [net, constant] = GENERATE(
      table<std::vector<int>, double>({{kCrossedAtTwoThirds, 2.0 / 3}, {kIrrationalFold, 0.190983005625}}));
  const IntersectionGraph graph = checked(patch(net));
  CHECK(degrees(graph, NodeKind::crossing).back() == 4);
  int on_line = 0;
  for (const Arc& arc : graph.arcs)
    on_line += std::ranges::all_of(arc.polyline, [&](const PolylineVertex& vertex) {
      const auto [u, v, r, s] = vertex.parameters;
      return u == Approx(constant) && r == Approx(constant) && v + s == Approx(1);
    });
  CHECK(on_line == 2);
}

TEST_CASE("a crossing at a pair with irrational parameters") {
  const BezierPatch x = patch(kIrrationalCrossing);
  const IntersectionGraph graph = checked(x);
  CHECK(degrees(graph, NodeKind::crossing) == std::vector{4});
}

TEST_CASE("sides that are glued up to the corner they have in common") {
  const IntersectionGraph graph = checked(patch(kGluedAtCorner));
  CHECK(std::ranges::count(graph.arcs, ArcPlace::patch_boundary, &Arc::place) == 2);
  CHECK(degrees(graph, NodeKind::crossing) == std::vector{3});
  const auto corner = std::ranges::find(graph.nodes, std::array<double, 4>{0, 1, 0, 1}, &Node::approx);
  REQUIRE(corner != graph.nodes.end());
  CHECK(std::ranges::count(corner->kinds, NodeKind::cusp) == 1);
  for (const Arc& arc : graph.arcs) {
    if (arc.place != ArcPlace::patch_boundary) continue;
    for (const PolylineVertex& vertex : arc.polyline) {
      const std::array<double, 4>& p = vertex.parameters;
      const std::size_t first = p[0] == 0 ? 0 : 2;
      CHECK(p[first] == 0);
      CHECK(p[3 - first] == 1);
      CHECK(p[first + 1] + p[2 - first] == Approx(1));
    }
  }
}

TEST_CASE("two parameters that turn in one pair") {
  const IntersectionGraph graph = checked(patch(kTurnTogether));
  CHECK(std::ranges::count_if(graph.nodes, [](const Node& node) {
          return std::ranges::count(node.wrt, Parameter::v) == 1 &&
                 std::ranges::count(node.wrt, Parameter::s) == 1;
        }) == 1);
}

TEST_CASE("a component of the tangent vanishes where a curve ends on a folded side") {
  const BezierPatch x = patch(kTangentAtFoldedSide);
  const IntersectionGraph graph = checked(x);
  const auto end = std::ranges::find_if(graph.nodes, [](const Node& node) {
    return node.on == std::vector<Side>{{Parameter::u, 1}} || node.on == std::vector<Side>{{Parameter::r, 1}};
  });
  REQUIRE(end != graph.nodes.end());
  CHECK(end->wrt.empty());
}

TEST_CASE("exact pairs at which a component of the tangent vanishes") {
  const BezierPatch x = patch(kTurnTogether);
  TurningPairs pairs(x);
  const IntersectionGraph graph = checked(x);
  int together = 0;
  for (const Node& node : graph.nodes) {
    if (node.wrt.empty()) continue;
    ParameterBox around;
    for (std::size_t j = 0; j < 4; ++j)
      around[j] = {from_double(node.approx[j]) - power_of_two(-30),
                   from_double(node.approx[j]) + power_of_two(-30)};
    const auto box = pairs.common_zero(around, 1, 3);
    CHECK(box.has_value() == (node.wrt.size() == 2));
    CHECK_FALSE(pairs.common_zero(around, 0, 1));
    if (!box) continue;
    ++together;
    // v1 + v2 = 1 on the curve, and the images agree.
    const auto& [u, v, r, s] = *box;
    CHECK(abs(v.midpoint() + s.midpoint() - 1) < power_of_two(-190));
    const Point gap = x(u.midpoint(), v.midpoint()) - x(r.midpoint(), s.midpoint());
    CHECK(dot(gap, gap) < power_of_two(-300));
  }
  CHECK(together == 1);
}

TEST_CASE("singular pairs over an irrational value, exactly") {
  const BezierPatch x = patch(kIrrationalCrossing);
  const SelfProjection projection = self_projection(x);
  int pairs = 0;
  const auto values = self_turning_values(x);
  REQUIRE(values);
  for (const RealAlgebraic& value : *values) {
    CHECK(irreducible_factors(value.polynomial()).size() == 1);
    if (value.is_rational() || value.polynomial().degree() > 4) continue;
    for (const ExactParameters& pair : singular_pairs_over(x, projection, value)) {
      ++pairs;
      CHECK(has_value(pair, 1, value));
      CHECK_FALSE(has_value(pair, 0, value));
      CHECK_FALSE(has_value(pair, 1, Rational(1, 2)));
      std::array<RationalInterval, 4> at;
      for (std::size_t j = 0; j < 4; ++j) at[j] = enclosure(pair, j, power_of_two(-200));
      // Substituted back: the images and the tangent planes of the two points agree.
      const Rational u = at[0].midpoint(), v = at[1].midpoint(), r = at[2].midpoint(), s = at[3].midpoint();
      const Point gap = x(u, v) - x(r, s);
      const Point normal = cross(x.derivative_first(u, v), x.derivative_second(u, v));
      const Point other = cross(x.derivative_first(r, s), x.derivative_second(r, s));
      CHECK(dot(gap, gap) < power_of_two(-300));
      CHECK(dot(cross(normal, other), cross(normal, other)) < power_of_two(-300));
      CHECK(abs(u - r) + abs(v - s) > Rational(1, 10));
    }
  }
  CHECK(pairs == 2);
}

TEST_CASE("a cuspidal corner at which the patch does not meet itself") {
  const IntersectionGraph graph = checked(patch(kCuspidalCorner));
  CHECK(std::ranges::none_of(graph.nodes, [](const Node& node) { return node.on.size() == 4; }));
}

TEST_CASE("a cuspidal corner, and a side that is one point") {
  const BezierPatch x = patch(kCornerAndPoint);
  const IntersectionGraph graph = checked(x);
  CHECK(graph.arcs.empty());
  REQUIRE(graph.nodes.size() == 1);
  CHECK(graph.nodes[0].free.size() == 2);
  // x_u x x_v = u f: the cuspidal points off the side are zeros of f.
  for (const BezierPatch& lines : {x, x.exchanged()}) {
    const auto values = cuspidal_values(lines);
    REQUIRE(values);
    CHECK(values->size() < 20);
  }
  CHECK(std::ranges::count(*cuspidal_values(x), RealAlgebraic(0)) == 1);
  CHECK(std::ranges::count(*cuspidal_values(x.exchanged()), RealAlgebraic(1)) == 1);
}

TEST_CASE("pairs over a value past a side that is one point") {
  const ParameterBox square = {{{0, 1}, {0, 1}, {0, 1}, {0, 1}}};
  const ParameterBox region = {{{Rational(1, 8), 1}, {0, 1}, {Rational(1, 8), 1}, {0, 1}}};
  std::ptrdiff_t found = 0;
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    CAPTURE(seed);
    std::mt19937 generator(seed);
    ControlNet net = random_patch(generator, 2).net();
    net[0][1] = net[0][2] = net[0][0];
    const BezierPatch x(net);
    for (const Rational& v : {Rational(1, 7), Rational(2, 3)}) {
      CHECK_FALSE(pairs_in(x, {Parameter::v, v}, square));
      const auto pairs = pairs_in(x, {Parameter::v, v}, region);
      REQUIRE(pairs);
      const auto fibre = self_fibre(x, 1, v);
      const auto expected = std::ranges::count_if(
          fibre, [&](const CertifiedPoint& point) { return lies_in(point.box(), region); });
      CHECK(static_cast<std::ptrdiff_t>(pairs->size()) == expected);
      found += expected;
    }
  }
  CHECK(found > 0);
}

TEST_CASE("a folded line turns in a part of it") {
  // (p^2, p h, h), p = u - 2/3: the line v = 0 turns at u = 2/3.
  ControlNet d{};
  d[2][0] = {1, 0, 0};
  d[1][1] = {0, 1, 0};
  d[0][1] = {0, 0, 1};
  const BezierPatch x = BezierPatch::from_power_basis(d).restricted_to(Rational(-2, 3), Rational(1, 3), 0, 1);
  const Rational turn(2, 3);
  CHECK(has_folded_line(x, 1, {0, Rational(1, 9)}, {0, 1}));
  CHECK(has_folded_line(x, 1, {0, Rational(1, 9)}, {turn, 1}));
  CHECK_FALSE(has_folded_line(x, 1, {0, Rational(1, 9)}, {Rational(3, 4), 1}));
  CHECK_FALSE(has_folded_line(x, 1, {0, Rational(1, 9)}, {0, Rational(3, 5)}));
}

TEST_CASE("a curve that ends in a cuspidal corner") {
  const IntersectionGraph graph = checked(patch(kCurveToCorner));
  const auto at_corner = std::ranges::find_if(graph.nodes, [](const Node& node) {
    return node.on.size() == 4 && std::ranges::count(node.kinds, NodeKind::cusp) == 1;
  });
  REQUIRE(at_corner != graph.nodes.end());
  CHECK(at_corner->approx == std::array<double, 4>{0, 0, 0, 0});
}

}  // namespace exsect::star_test
