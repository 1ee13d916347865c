// Points at which patches are singular against themselves in doubles: pinch points inside, on sides and in
// corners, sides that turn back, touch points of two sheets.
#include "self_in_doubles.h"

namespace exsect::singular_in_doubles_test {
namespace {

using namespace self_in_doubles;

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

}  // namespace exsect::singular_in_doubles_test
