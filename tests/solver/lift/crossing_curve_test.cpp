// Curves of two polynomials against the same surfaces by their names, against slices by planes, and on curves
// that are known.
#include "lift/crossing_curve.h"

#include <exsect/algebra/resultant.h>
#include <exsect/algebra/sturm.h>
#include <exsect/geometry/surface_box.h>
#include <exsect/solver/intersect_equations.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "support/catch.h"

namespace exsect::crossing_curve_test {
namespace {

using S = ImplicitSurface;
const Point origin = {0, 0, 0}, up = {0, 0, 1}, right = {1, 0, 0}, oblique = {1, 1, 1};

IntersectOptions coarse() {
  IntersectOptions options;
  options.tolerance = 1e-3;
  return options;
}

/// "2 closed, 1 open, 1 touch", or why it is incomplete.
std::string census(const SurfaceIntersection& result) {
  if (result.status != Status::complete) return result.incomplete.at(0).why;
  if (result.is_same) return "same";
  int closed = 0;
  for (const SpaceCurve& curve : result.curves) closed += curve.is_closed ? 1 : 0;
  std::string text = std::to_string(closed) + " closed, " +
                     std::to_string(static_cast<int>(result.curves.size()) - closed) + " open";
  for (const SpaceNodeKind kind : {SpaceNodeKind::touch, SpaceNodeKind::crossing, SpaceNodeKind::singular})
    if (result.count(kind) > 0) text += ", " + std::to_string(result.count(kind)) + " " + name(kind);
  int order = 1;
  for (const SpaceCurve& curve : result.curves) order = std::max(order, curve.multiplicity);
  return order > 1 ? text + ", order " + std::to_string(order) : text;
}

std::string census(const S& first, const S& second) {
  const std::string text = census(intersect(first, second, coarse()));
  CHECK(census(intersect(second, first, coarse())) == text);
  return text;
}

/// The same points without the name.
S unnamed(const S& surface) { return S::polynomial(surface.equation()); }

/// The number of points of F = G = 0 in the plane z = c: zeros of the resultant of a sheared slice.
int points_in_slice(const SpacePolynomial& f, const SpacePolynomial& g, const Rational& c) {
  const auto slice = [&](const SpacePolynomial& of) {
    BivariatePolynomial sum;
    const BivariatePolynomial r = BivariatePolynomial::r();
    const BivariatePolynomial s = BivariatePolynomial::s() + BivariatePolynomial::constant(3) * r;
    for (const auto& [e, k] : of.terms()) {
      BivariatePolynomial term = BivariatePolynomial::constant(k);
      for (int i = 0; i < e[0]; ++i) term = term * r;
      for (int i = 0; i < e[1]; ++i) term = term * s;
      for (int i = 0; i < e[2]; ++i) term = term * BivariatePolynomial::constant(c);
      sum += term;
    }
    return sum;
  };
  return SturmSequence(resultant_r(slice(f), slice(g))).count_all();
}

/// How often the polylines cross the plane.
int crossings(const SurfaceIntersection& result, double c) {
  int count = 0;
  for (const SpaceArc& arc : result.arcs)
    for (std::size_t k = 0; k + 1 < arc.polyline.size(); ++k)
      count += (arc.polyline[k][2] < c) != (arc.polyline[k + 1][2] < c) ? 1 : 0;
  return count;
}

/// Of closed curves.
void check_slices(const S& first, const S& second, const std::vector<Rational>& heights) {
  IntersectOptions options;
  options.tolerance = 1e-5;
  const SurfaceIntersection result = intersect(first, second, options);
  REQUIRE(result.status == Status::complete);
  for (const Rational& c : heights)
    CHECK(crossings(result, to_double(c)) == points_in_slice(first.equation(), second.equation(), c));
}

S random_quadric(std::mt19937& random) {
  const auto number = [&](int most) {
    return Rational(std::uniform_int_distribution<int>(-most, most)(random));
  };
  const Point at = {number(3) / 2, number(3) / 2, number(3) / 2};
  Point axis = {number(4), number(4), number(4)};
  if (is_zero(axis)) axis = oblique;
  const Rational size = 1 + abs(number(6)) / 3;
  switch (std::uniform_int_distribution<int>(0, 3)(random)) {
    case 0:
      return S::sphere(at, Length::of_squared(3 * size));
    case 1:
      return S::cylinder(at, axis, Length::of_squared(size));
    case 2:
      return S::cone(at, axis, Length::of_squared(size / 2), 2);
    default:
      return S::torus(at, axis, 2 + size, 1);
  }
}

SpacePolynomial random_polynomial(std::mt19937& random, int degree) {
  SpacePolynomial::Terms terms;
  std::uniform_int_distribution<int> coefficient(-5, 5);
  for (const Exponents& e : exponents_up_to(degree)) terms[e] = coefficient(random);
  for (std::size_t k = 0; k < 3; ++k) {
    Exponents e{};
    e[k] = degree;
    terms[e] = 5;
  }
  terms[{0, 0, 0}] = -8;
  return SpacePolynomial(terms);
}

}  // namespace

TEST_CASE("crossing curve: conics, and their neighbours that are empty") {
  const S ball = unnamed(S::sphere(origin, 2));
  CHECK(census(ball, unnamed(S::sphere({1, 0, 0}, 2))) == "1 closed, 0 open");
  CHECK(census(ball, unnamed(S::sphere({5, 0, 0}, 2))) == "0 closed, 0 open");
  CHECK(census(ball, unnamed(S::sphere(origin, 3))) == "0 closed, 0 open");
  CHECK(census(ball, unnamed(S::plane({1, 0, 0}, oblique))) == "1 closed, 0 open");
  CHECK(census(unnamed(S::plane({1, 0, 0}, oblique)), unnamed(S::plane(origin, up))) == "0 closed, 1 open");
  CHECK(census(unnamed(S::plane({0, 0, 1}, up)), unnamed(S::plane(origin, up))) == "0 closed, 0 open");
  CHECK(census(ball, S::polynomial(Rational(-3) * ball.equation())) == "same");
  CHECK(census(unnamed(S::cylinder(origin, up, 1)), unnamed(S::cylinder({1, 0, 0}, up, 1))) ==
        "0 closed, 2 open");
  CHECK(census(unnamed(S::cylinder(origin, up, 2)), unnamed(S::cylinder(origin, right, 1))) ==
        "2 closed, 0 open");
}

TEST_CASE("crossing curve: lines and conics have their names and data") {
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                        z = SpacePolynomial::variable(2), one = SpacePolynomial::constant(1);
  const auto number = [](const Rational& q) { return SpacePolynomial::constant(q); };
  const auto meet = [](const SpacePolynomial& f, const SpacePolynomial& g) {
    const SurfaceIntersection result = intersect(S::polynomial(f), S::polynomial(g), coarse());
    REQUIRE(result.status == Status::complete);
    return result;
  };
  const auto kinds = [](const SurfaceIntersection& result) {
    std::map<std::string, int> counts;
    for (const SpaceCurve& curve : result.curves) ++counts[name(curve.kind)];
    return counts;
  };
  using Kinds = std::map<std::string, int>;
  const SpacePolynomial ball = x * x + y * y + z * z - number(9), shifted = x - number(2);
  const SurfaceIntersection circle = meet(ball, shifted * shifted + y * y + z * z - number(9));
  REQUIRE(kinds(circle) == Kinds{{"circle", 1}});
  CHECK(circle.curves[0].is_closed);
  CHECK(*circle.curves[0].point == right);
  CHECK(*circle.curves[0].radius_squared == 8);
  CHECK(is_zero(cross(*circle.curves[0].direction, right)));
  // Two ellipses of x^2 + y^2 = 1 in the planes z = +-2x, and two hyperbolas in those of x^2 - y^2 = 1.
  const SpacePolynomial planes = z * z - number(4) * x * x;
  const SurfaceIntersection ellipses = meet(x * x + y * y - one, planes);
  CHECK(kinds(ellipses) == Kinds{{"ellipse", 2}});
  CHECK(ellipses.count(SpaceNodeKind::crossing) == 2);
  for (const SpaceCurve& ellipse : ellipses.curves) {
    CHECK(*ellipse.point == origin);
    CHECK((*ellipse.direction)[0] * (*ellipse.direction)[0] ==
          4 * (*ellipse.direction)[2] * (*ellipse.direction)[2]);
  }
  CHECK(kinds(meet(x * x - y * y - one, planes)) == Kinds{{"hyperbola", 2}});
  // A paraboloid in the planes y = 1, a parabola, and z = 5 - y, an ellipse; another one in planes with a
  // circle.
  const SpacePolynomial bowl = z - x * x - y * y;
  CHECK(kinds(meet(bowl, bowl + (y - one) * (z + y - number(5)))) == Kinds{{"ellipse", 1}, {"parabola", 1}});
  CHECK(kinds(meet(bowl, bowl + (y - one) * (z - number(5)))) == Kinds{{"circle", 1}, {"parabola", 1}});
  // Rational lines of a saddle.
  const SpacePolynomial saddle = z - x * y;
  const SurfaceIntersection lines = meet(saddle, saddle + (x - number(2)) * (y - number(3)));
  REQUIRE(kinds(lines) == Kinds{{"line", 2}});
  for (const SpaceCurve& line : lines.curves)
    for (const int t : {0, 1, 5}) {
      const Point p = *line.point + Rational(t) * *line.direction;
      CHECK(saddle(p) == 0);
      CHECK((p[0] - 2) * (p[1] - 3) == 0);
    }
  // Conjugate over a quadratic field: lines, ellipses, circles, hyperbolas, and an ellipse with a hyperbola.
  CHECK(kinds(meet(x * x + y * y - one, x * x - number(Rational(1, 2)))) == Kinds{{"line", 4}});
  CHECK(kinds(meet(x * x - number(2), z - y)) == Kinds{{"line", 2}});
  CHECK(kinds(meet(x * x + y * y - one, z * z - number(2) * x * x)) == Kinds{{"ellipse", 2}});
  const SurfaceIntersection circles = meet(bowl, z * z - number(4) * z + number(2));
  CHECK(kinds(circles) == Kinds{{"circle", 2}});
  for (const SpaceCurve& curve : circles.curves) CHECK(is_zero(cross(*curve.direction, up)));
  CHECK(kinds(meet(x * x - y * y - one, z * z - number(2) * y * y)) == Kinds{{"hyperbola", 2}});
  // The planes (1 +- w) x = z, w^2 = 2, with x^2 + y^2 - z^2 / 4 = 1.
  CHECK(kinds(meet(x * x + y * y - Rational(1, 4) * z * z - one, z * z - number(2) * x * z - x * x)) ==
        Kinds{{"ellipse", 1}, {"hyperbola", 1}});
  // Neighbours have no names.
  const Rational little = power_of_two(-40);
  CHECK(kinds(meet(x * x + y * y - one, planes + number(little))) == Kinds{{"general", 2}});
}

TEST_CASE(
    "crossing curve: named conics at all sizes, turned, and as they are named with the surfaces' names") {
  const Rational third(1, 3);
  for (const Rational& size : {Rational(1), Rational(254, 10), Rational(1, 1000000)})
    for (const Rational& far : {Rational(0), Rational(100000000)}) {
      const Point at = far * oblique, axis = third * Point{2, 2, 1};
      const S tube = S::cylinder(at, axis, size), wall = S::plane(at + size * right, {3, 1, 2});
      const SurfaceIntersection named = intersect(tube, wall, coarse());
      const SurfaceIntersection without = intersect(unnamed(tube), unnamed(wall), coarse());
      REQUIRE(named.count(SpaceCurveKind::ellipse) == 1);
      REQUIRE(without.count(SpaceCurveKind::ellipse) == 1);
      CHECK(*named.curves[0].point == *without.curves[0].point);
      CHECK(is_zero(cross(*named.curves[0].direction, *without.curves[0].direction)));
    }
}

TEST_CASE("crossing curve: what is near to contact, at sizes of all kinds") {
  for (const int k : {-3, -6, -9, -12}) {
    const Rational gap = power_of_two(3 * k);
    const S ball = unnamed(S::sphere(origin, 1)), above = unnamed(S::sphere({2 - gap, 0, 0}, 1));
    CHECK(census(ball, above) == "1 closed, 0 open");
    CHECK(census(ball, unnamed(S::sphere({2 + gap, 0, 0}, 1))) == "0 closed, 0 open");
    CHECK(census(unnamed(S::cylinder(origin, up, 1 + gap)), unnamed(S::cylinder(origin, right, 1))) ==
          "2 closed, 0 open");
  }
  for (const Rational& scale : {Rational(254, 10), Rational(100000000), Rational(1, 1000000)}) {
    const Point far = Rational(100000000) * oblique;
    const S ball = unnamed(S::sphere(far, scale)), bore = unnamed(S::cylinder(far, oblique, scale / 3));
    CHECK(census(ball, bore) == "2 closed, 0 open");
  }
}

TEST_CASE("crossing curve: touch points and singular points") {
  const auto same_without_names = [](const S& first, const S& second) {
    const std::string named = census(intersect(first, second, coarse()));
    CHECK(census(unnamed(first), unnamed(second)) == named);
    return named;
  };
  const S ball = S::sphere(origin, 2), tube = S::cylinder(origin, up, 1);
  CHECK(same_without_names(ball, S::sphere({4, 0, 0}, 2)) == "0 closed, 0 open, 1 touch");
  CHECK(same_without_names(tube, S::cylinder(origin, right, 1)) == "2 closed, 0 open, 2 crossing");
  CHECK(same_without_names(ball, S::cylinder({1, 0, 0}, up, 1)) == "1 closed, 0 open, 1 crossing");
  CHECK(same_without_names(ball, S::cylinder({3, 0, 0}, {1, 2, 0}, Length::of_squared(Rational(49, 20)))) !=
        "same");
  CHECK(same_without_names(tube, S::cylinder({0, 3, 0}, right, 2)) == "0 closed, 0 open, 1 touch");
  CHECK(same_without_names(tube, S::cylinder({0, 1, 0}, right, 2)) == "1 closed, 0 open, 1 crossing");
  CHECK(same_without_names(S::plane(origin, up), S::torus(origin, right, 3, 1)) == "2 closed, 0 open");
  CHECK(same_without_names(S::plane({2, 0, 0}, right), S::torus(origin, up, 3, 1)) ==
        "1 closed, 0 open, 1 crossing");
  CHECK(same_without_names(S::cone(origin, up, 1, 2), S::plane(origin, {5, 0, -4})) ==
        "0 closed, 2 open, 1 crossing");
  CHECK(same_without_names(S::cone(origin, up, 1, 2), S::sphere({1, 0, 0}, 1)) ==
        "1 closed, 0 open, 1 crossing");
  CHECK(same_without_names(S::cone(origin, up, 1, 2), S::sphere({0, 0, 1}, 1)) != "same");
  // Two branches that are tangent to each other.
  CHECK(same_without_names(S::torus({-1, 2, -1}, {0, 1, 0}, 3, 1), S::cylinder({0, 1, 2}, right, 2)) ==
        "1 closed, 0 open, 1 crossing");
}

TEST_CASE("crossing curve: points in which both surfaces are singular") {
  const auto ends = [](const S& first, const S& second) {
    const SurfaceIntersection result = intersect(first, second, coarse());
    REQUIRE(result.status == Status::complete);
    std::map<std::string, int> counts;
    for (const SpaceNode& node : result.nodes)
      if (node.kind != SpaceNodeKind::joint) ++counts[name(node.kind) + std::to_string(node.degree)];
    return counts;
  };
  // Cones of one apex, at a rational and at an irrational slope, against the same with their names.
  const Point apex = {1, -2, Rational(1, 3)};
  const S both = S::cone(apex, up, 1, 2);
  for (const S& other :
       {S::cone(apex, {1, 0, 2}, 1, 2), S::cone(apex, oblique, Rational(1, 2), 2), S::cone(apex, right, 1, 2),
        S::cone(apex, right, Length::of_squared(Rational(1, 7)), 2),
        S::cone(apex, {1, 2, 3}, Length::of_squared(3), 2)})
    CHECK(ends(unnamed(both), unnamed(other)) == ends(both, other));
  // Two nodes with closed curves through them, and one with a cusp of the other surface: against slices.
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                        z = SpacePolynomial::variable(2);
  const SpacePolynomial square = x * x + y * y + z * z;
  const S node = S::polynomial(z * z - x * x - y * y - square * square),
          cusp = S::polynomial(x * x + y * y * y - z * x * y);
  const std::vector<Rational> heights = {Rational(-3, 4), Rational(-1, 5), Rational(1, 7), Rational(2, 3)};
  check_slices(node, unnamed(S::cone(origin, {1, 2, 9}, Rational(1, 2), 2)), heights);
  check_slices(node, cusp, heights);
  // Neighbours: the apex moved by 2^-20.
  const S near = S::cone(apex + power_of_two(-20) * oblique, {1, 0, 2}, 1, 2);
  CHECK(ends(unnamed(both), unnamed(near)) == ends(both, near));
}

TEST_CASE("crossing curve: irrational and oblique touch points") {
  // The greatest circle of the torus has the radius 3 sqrt(2), a point of it is 3 (1, -1, 0).
  const S torus = S::torus(origin, oblique, Length::of_squared(8), Length::of_squared(2));
  const Point aside = {1, -1, 0};
  const auto ball = [&](const Rational& at) { return S::sphere(at * aside, Length::of_squared(2)); };
  CHECK(census(unnamed(torus), unnamed(ball(4))) == "0 closed, 0 open, 1 touch");
  CHECK(census(unnamed(torus), unnamed(ball(4 + power_of_two(-30)))) == "0 closed, 0 open");
  CHECK(census(unnamed(torus), unnamed(ball(4 - power_of_two(-30)))) == "1 closed, 0 open");
  // Two equal tori, centres at twice (R + r) apart: R = 3, r = 1, irrational axis.
  const S left = S::torus(origin, {1, 2, 3}, 3, 1), beyond = S::torus({8, 0, 0}, {0, 2, 3}, 3, 1);
  CHECK(census(unnamed(left), unnamed(beyond)) == census(intersect(left, beyond, coarse())));
  // A cusp: y^2 = x^3 in the plane z = 0, and as a cylinder cut by a paraboloid.
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                        z = SpacePolynomial::variable(2);
  CHECK(census(S::polynomial(y * y - x * x * x), S::polynomial(z - x * x - y * y)) ==
        "0 closed, 1 open, 1 singular");
  // Three sheets through a point, tangent to each other, and an isolated point of the curve.
  CHECK(census(S::polynomial(y * y - x * x * x * x), S::polynomial(z - y)) == "0 closed, 2 open, 1 crossing");
  CHECK(census(S::polynomial(y * y + x * x * x * x - x * x * x), S::polynomial(z - x)) ==
        "1 closed, 0 open, 1 singular");
  CHECK(census(S::polynomial(x * x + y * y - x * x * x), S::polynomial(z - x * y)) ==
        "0 closed, 1 open, 1 touch");
}

TEST_CASE("crossing curve: curves of contact, and surfaces next to them") {
  const S ball = unnamed(S::sphere(origin, 1));
  const auto tube = [](const Rational& radius) { return unnamed(S::cylinder(origin, oblique, radius)); };
  CHECK(census(ball, tube(1)) == "1 closed, 0 open, order 2");
  const S torus = unnamed(S::torus(origin, oblique, 3, 1));
  const S inner = unnamed(S::sphere(origin, 2)), across = S::sphere({3, 0, 0}, 2);
  CHECK(census(torus, inner) == "1 closed, 0 open, order 2");
  CHECK(census(torus, unnamed(across)) == census(torus, across));
  for (const int k : {4, 8}) {
    const Rational gap = power_of_two(-k);
    CHECK(census(ball, tube(1 - gap)) == "2 closed, 0 open");
    CHECK(census(ball, tube(1 + gap)) == "0 closed, 0 open");
    CHECK(census(torus, unnamed(S::sphere(origin, 2 + gap))) == "2 closed, 0 open");
  }
}

TEST_CASE("crossing curve: circles that a torus shares with what touches it, without names and frames") {
  // Circles of the tube in the plane y = 0, which a sphere, a cylinder and another torus touch. On cylinder
  // and torus the order is higher at the top and the bottom, where curves cross that one.
  const S torus = S::torus(origin, up, 3, 1), bead = S::sphere({3, 0, 0}, 1);
  const S bore = S::cylinder({3, 0, 0}, {0, 1, 0}, 1), twin = S::torus({1, 0, 0}, up, 2, 1);
  CHECK(census(unnamed(torus), unnamed(bead)) == "1 closed, 0 open, order 2");
  for (const S& other : {bead, bore, S::cylinder(origin, up, 4), S::plane({0, 0, 1}, up)})
    CHECK(census(unnamed(torus), unnamed(other)) == census(intersect(torus, other, coarse())));
  CHECK(census(unnamed(torus), unnamed(twin)) == census(intersect(torus, twin, coarse())));
}

TEST_CASE("crossing curve: contact of orders 3 and 4 along curves") {
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                        z = SpacePolynomial::variable(2);
  const auto number = [](int c) { return SpacePolynomial::constant(c); };
  const SpacePolynomial ball = x * x + y * y + z * z - number(2), h = x + Rational(2) * y - z;
  const SpacePolynomial bowl = x * x + y * y - z, k = x + Rational(2) * z - number(3);
  const SpacePolynomial tube = x * x + y * y - number(1);
  const auto touching = [&](const SpacePolynomial& f, const SpacePolynomial& g) {
    return census(S::polynomial(f), S::polynomial(g));
  };
  CHECK(touching(ball * (x + number(3)) + h * h * h, ball) == "1 closed, 0 open, order 3");
  CHECK(touching(tube * (x + Rational(2) * z) + h * h * h, tube) == "1 closed, 0 open, order 3");
  CHECK(touching(bowl + k * k * k, bowl) == "1 closed, 0 open, order 3");
  CHECK(touching(ball + h * h * h * h, ball) == "1 closed, 0 open, order 4");
  CHECK(touching(bowl * (x * y + number(5)) + k * k * k * k, bowl) == "1 closed, 0 open, order 4");
}

TEST_CASE("crossing curve: contact along curves of polynomials, and squares") {
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                        z = SpacePolynomial::variable(2), one = SpacePolynomial::constant(1);
  const SpacePolynomial ball = x * x + y * y + z * z - Rational(2) * one, h = x + Rational(2) * y - z;
  // The curve of contact is a sphere's with a quadric, and another circle crosses it.
  const SpacePolynomial bent = x * y - z;
  CHECK(census(S::polynomial(Rational(3) * ball + bent * bent), S::polynomial(ball)) ==
        "1 closed, 0 open, order 2");
  const SpacePolynomial crossed = ball * (x + one) + h * h * (z - Rational(1, 3) * one);
  CHECK(census(S::polynomial(crossed), S::polynomial(ball)) == "2 closed, 0 open, 2 crossing, order 2");
  const SpacePolynomial tube = x * x + y * y - one;
  CHECK(census(S::polynomial(tube * tube), S::polynomial(ball)) == "2 closed, 0 open, order 2");
  CHECK(census(S::polynomial(tube * tube), S::polynomial(ball * ball)) == "2 closed, 0 open, order 4");
  // Two circles, of which one is where the ball crosses a double plane.
  CHECK(census(S::polynomial(h * h * (z - Rational(1, 3) * one)), S::polynomial(ball)) ==
        "2 closed, 0 open, 2 crossing, order 2");
}

TEST_CASE("crossing curve: common factors") {
  const SpacePolynomial ball = S::sphere(origin, 2).equation(),
                        plane = S::plane({0, 0, 1}, oblique).equation(),
                        tube = S::cylinder(origin, up, 1).equation(),
                        far = S::plane({0, 0, 9}, up).equation();
  const auto shared = [](const SpacePolynomial& f, const SpacePolynomial& g) {
    const SurfaceIntersection result = intersect(S::polynomial(f), S::polynomial(g), coarse());
    CHECK(result.is_same);
    SurfaceIntersection besides = result;
    besides.is_same = false;
    CHECK(census(S::polynomial(g), S::polynomial(f)) == "same");
    return census(besides);
  };
  CHECK(shared(ball, ball * plane) == "0 closed, 0 open");
  CHECK(shared(ball * plane, ball * far) == "0 closed, 1 open");
  CHECK(shared(plane * tube, plane * ball) == "2 closed, 0 open");
  CHECK(shared(plane * tube, Rational(-2) * plane * tube) == "0 closed, 0 open");
  CHECK(shared(plane * plane, plane * far) == "0 closed, 1 open");
  CHECK(shared(tube * tube, tube * ball) == "2 closed, 0 open");
}

TEST_CASE("crossing curve: surfaces with and without their names") {
  const unsigned seed = 20261126;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  int compared = 0, curves = 0;
  for (int round = 0; round < 24; ++round) {
    const S first = random_quadric(random), second = random_quadric(random);
    const bool are_tori = first.kind() == SurfaceKind::torus && second.kind() == SurfaceKind::torus;
    if (are_tori && round > 12) continue;
    INFO(round << ": " << name(first.kind()) << " and " << name(second.kind()));
    const std::string named = census(intersect(first, second, coarse()));
    const std::string without = census(intersect(unnamed(first), unnamed(second), coarse()));
    if (named == "same") continue;
    CHECK(without == named);
    ++compared;
    curves += named != "0 closed, 0 open" ? 1 : 0;
  }
  CHECK(compared >= 16);
  CHECK(curves >= 8);
}

TEST_CASE("crossing curve: polynomials against slices") {
  const unsigned seed = 4;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const std::vector<Rational> heights = {Rational(-9, 7), Rational(-2, 3), Rational(-1, 5),
                                         Rational(2, 11), Rational(5, 8),  Rational(14, 13)};
  for (const auto& [m, n] : {std::pair(2, 2), std::pair(2, 2), std::pair(4, 2)})
    check_slices(S::polynomial(random_polynomial(random, m)), S::polynomial(random_polynomial(random, n)),
                 heights);
}

TEST_CASE("crossing curve: two tori of neither of which a ratio is rational") {
  const auto torus = [](const Point& centre, const Point& axis, int major, const Rational& minor_squared) {
    return S::torus(centre, axis, major, Length::of_squared(minor_squared));
  };
  CHECK(census(torus(origin, oblique, 3, 2), torus(right, oblique, 3, 2)) == "2 closed, 0 open");
  CHECK(census(torus(origin, oblique, 3, 2), torus({9, 0, 0}, oblique, 3, 2)) == "0 closed, 0 open");
  // Links of a chain: apart, and with two closed curves where the tubes meet on one side.
  const S link = torus(origin, {1, 1, 0}, 4, Rational(1, 2));
  CHECK(census(link, torus({0, 0, 4}, {1, -1, 1}, 4, Rational(1, 3))) == "0 closed, 0 open");
  check_slices(link, torus({1, 0, 1}, {1, 2, 1}, 4, Rational(1, 3)),
               {Rational(-19, 6), Rational(-3, 2), Rational(1, 7), Rational(9, 5), Rational(10, 3)});
  check_slices(link, unnamed(S::sphere({4, -4, 1}, 3)), {Rational(1, 7), Rational(9, 5), Rational(-8, 3)});
}

}  // namespace exsect::crossing_curve_test
