#include <exsect/geometry/beyond_doubles.h>
#include <exsect/solver/intersect_equations.h>

#include <cmath>
#include <map>
#include <string>

#include "support/catch.h"

namespace exsect::intersect_equations_test {
namespace {

using S = ImplicitSurface;
using Kind = SpaceCurveKind;

const Point origin = {0, 0, 0}, up = {0, 0, 1}, right = {1, 0, 0}, oblique = {1, 1, 1};

/// "2 ellipse, 2 crossing" and so on: the kinds of curves, those with contact and those that are closed
/// marked by *k and o, then the nodes that are no joints.
std::string census(const SurfaceIntersection& result) {
  if (result.status != Status::complete) return "incomplete: " + result.incomplete.at(0).why;
  if (result.is_same) return "same";
  std::map<std::string, int> counts;
  for (const SpaceCurve& curve : result.curves)
    ++counts[std::string("1 ") + name(curve.kind) + (curve.is_closed ? " o" : "") +
             (curve.multiplicity > 1 ? " *" + std::to_string(curve.multiplicity) : "")];
  for (const SpaceNode& node : result.nodes)
    if (node.kind != SpaceNodeKind::joint) ++counts[std::string("2 ") + name(node.kind)];
  std::string text;
  for (const auto& [what, count] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + what.substr(1);
  return text.empty() ? "nothing" : text;
}

IntersectOptions coarse() {
  IntersectOptions options;
  options.tolerance = 1e-3;
  return options;
}

std::string census(const S& first, const S& second) {
  const std::string text = census(intersect(first, second, coarse()));
  CHECK(census(intersect(second, first, coarse())) == text);
  return text;
}

Rational tenth_to(int k) {
  Rational value = 1;
  for (int i = 0; i < k; ++i) value /= 10;
  return value;
}
const std::vector<int> near = {3, 6, 10, 20};

const std::string general = "1 general o", nothing = "nothing";

}  // namespace

TEST_CASE("equations: two planes") {
  CHECK(census(S::plane(origin, up), S::plane({1, 2, 0}, {0, 0, 3})) == "same");
  CHECK(census(S::plane(origin, up), S::plane({1, 2, tenth_to(20)}, {0, 0, 3})) == nothing);
  const SurfaceIntersection line = intersect(S::plane(origin, up), S::plane({1, 2, 3}, oblique));
  CHECK(census(line) == "1 line, 2 cut");
  CHECK(dot(*line.curves[0].direction, up) == 0);
  CHECK(dot(*line.curves[0].point - Point{1, 2, 3}, oblique) == 0);
}

TEST_CASE("equations: a sphere through meridian circles of a torus") {
  // Its centre is on tangents of the circle of the tube's centres: in the planes at 45 degrees, and others.
  const S torus = S::torus(origin, up, 5, 2);
  const auto ball = [](const Point& at, const Rational& reach_squared) {
    return S::sphere(at, Length::of_squared(dot(at, at) - 25 + 4 + reach_squared));
  };
  const SurfaceIntersection rational = intersect(torus, ball({Rational(25, 3), 0, 0}, 0), coarse());
  REQUIRE(census(rational) == "2 circle o");
  for (const SpaceCurve& circle : rational.curves) {
    CHECK(*circle.radius_squared == 4);
    CHECK((*circle.point)[0] == 3);
    CHECK(abs((*circle.point)[1]) == 4);
    CHECK(dot(*circle.direction, *circle.point) == 0);
  }
  CHECK((*rational.curves[0].point)[1] == -(*rational.curves[1].point)[1]);
  const SurfaceIntersection irrational = intersect(torus, ball({7, 0, 0}, 0), coarse());
  REQUIRE(census(irrational) == "2 circle o");
  for (const SpaceCurve& circle : irrational.curves) {
    CHECK(*circle.radius_squared == 4);
    CHECK_FALSE(circle.point);
    for (const int arc : circle.arcs)
      for (const auto& p : irrational.arcs[static_cast<std::size_t>(arc)].polyline)
        CHECK((p[1] > 0) == (irrational.arcs[static_cast<std::size_t>(circle.arcs[0])].polyline[1][1] > 0));
  }
  for (const int k : near) CHECK(census(torus, ball({7, 0, 0}, tenth_to(k))) == "2 general o");
}

TEST_CASE("equations: a plane and a sphere, at, beside and beyond the contact") {
  const S ball = S::sphere(oblique, Length::of_squared(3));
  const auto plane = [&](const Rational& shift) { return S::plane(shift * oblique, oblique); };
  CHECK(census(plane(2), ball) == "1 touch");
  CHECK(census(plane(0), ball) == "1 touch");
  for (const int k : near) {
    CHECK(census(plane(2 + tenth_to(k)), ball) == nothing);
    CHECK(census(plane(2 - tenth_to(k)), ball) == "1 circle o");
  }
  const SurfaceIntersection circle = intersect(plane(Rational(3, 2)), ball);
  CHECK(*circle.curves.at(0).radius_squared == Rational(9, 4));
  CHECK(*circle.curves[0].point == Rational(3, 2) * oblique);
}

TEST_CASE("equations: sections of a cone") {
  const S cone = S::cone(origin, up, 1), both = S::cone(origin, up, 1, 2);
  CHECK(census(cone, S::plane({0, 0, 1}, up)) == "1 circle o");
  CHECK(census(cone, S::plane({0, 0, -1}, up)) == nothing);
  CHECK(census(both, S::plane({0, 0, -1}, up)) == "1 circle o");
  CHECK(census(cone, S::plane(origin, up)) == "1 touch");
  CHECK(census(cone, S::plane({0, 0, 1}, {1, 0, 2})) == "1 ellipse o");
  CHECK(census(cone, S::plane({0, 0, 1}, {1, 0, 1})) == "1 parabola, 2 cut");
  CHECK(census(cone, S::plane({0, 0, 1}, {2, 0, 1})) == "1 hyperbola, 2 cut");
  CHECK(census(both, S::plane({0, 0, 1}, {2, 0, 1})) == "1 hyperbola, 4 cut");
  CHECK(census(cone, S::plane(origin, {1, 0, 1})) == "1 line *2, 1 cut, 1 end");
}

TEST_CASE("equations: planes through the apex") {
  const S cone = S::cone(origin, up, 1), both = S::cone(origin, up, 1, 2);
  CHECK(census(both, S::plane(origin, {1, 0, 0})) == "2 line, 1 crossing, 4 cut");
  CHECK(census(both, S::plane(origin, {2, 1, 1})) == "2 line, 1 crossing, 4 cut");
  CHECK(census(both, S::plane(origin, {1, 0, 1})) == "1 line *2, 2 cut, 1 singular");
  CHECK(census(cone, S::plane(origin, {1, 0, 0})) == "2 line, 2 cut, 1 singular");
  CHECK(census(cone, S::plane(origin, {0, 1, 3})) == "1 touch");
}

TEST_CASE("equations: a plane and a cylinder with an axis without rational points") {
  const S cylinder = S::cylinder(origin, oblique, 1);
  CHECK(census(cylinder, S::plane({5, 0, 0}, oblique)) == "1 circle o");
  CHECK(*intersect(cylinder, S::plane({5, 0, 0}, oblique)).curves.at(0).radius_squared == 1);
  CHECK(census(cylinder, S::plane({5, 0, 0}, up)) == "1 ellipse o");
  CHECK(census(cylinder, S::plane(origin, {1, -1, 0})) == "2 line, 4 cut");
  // (1,-1,0) t has the length 1 for t = 1/sqrt(2), irrational: the tangent plane of another radius.
  const S other = S::cylinder(origin, oblique, Length::of_squared(2));
  CHECK(census(other, S::plane({1, -1, 0}, {1, -1, 0})) == "1 line *2, 2 cut");
  for (const int k : near) {
    CHECK(census(other, S::plane({1 + tenth_to(k), -1, 0}, {1, -1, 0})) == nothing);
    CHECK(census(other, S::plane({1 - tenth_to(k), -1, 0}, {1, -1, 0})) == "2 line, 4 cut");
  }
}

TEST_CASE("equations: parallel cylinders") {
  const auto pair = [](const Rational& distance) {
    return census(S::cylinder(origin, up, 1), S::cylinder({distance, 0, 5}, {0, 0, -2}, 1));
  };
  CHECK(pair(0) == "same");
  CHECK(pair(2) == "1 line *2, 2 cut");
  for (const int k : near) {
    CHECK(pair(2 + tenth_to(k)) == nothing);
    CHECK(pair(2 - tenth_to(k)) == "2 line, 4 cut");
    CHECK(pair(tenth_to(k)) == "2 line, 4 cut");
  }
  CHECK(census(S::cylinder(origin, up, 1), S::cylinder(origin, up, 2)) == nothing);
}

TEST_CASE("equations: crossing cylinders") {
  CHECK(census(S::cylinder(origin, up, 1), S::cylinder(origin, right, 1)) == "2 ellipse o, 2 crossing");
  // The planes of the ellipses are conjugate: |(1,1,1)| is irrational.
  CHECK(census(S::cylinder(origin, oblique, 1), S::cylinder(origin, right, 1)) == "2 ellipse o, 2 crossing");
  for (const int k : near) {
    CHECK(census(S::cylinder(origin, up, 1 + tenth_to(k)), S::cylinder(origin, right, 1)) == "2 general o");
    CHECK(census(S::cylinder(origin, up, 1), S::cylinder({0, tenth_to(k), 0}, right, 1)) == general);
  }
  CHECK(census(S::cylinder(origin, up, 1), S::cylinder({0, 2, 0}, right, 1)) == "1 touch");
  CHECK(census(S::cylinder(origin, up, 2), S::cylinder({0, 1, 0}, right, 1)) == "1 general o, 1 crossing");
}

TEST_CASE("equations: Viviani's curve and its neighbours") {
  const S ball = S::sphere(origin, 2);
  CHECK(census(S::cylinder({1, 0, 0}, up, 1), ball) == "1 general o, 1 crossing");
  for (const int k : near) {
    CHECK(census(S::cylinder({1, 0, 0}, up, 1 + tenth_to(k)), ball) == general);
    CHECK(census(S::cylinder({1, 0, 0}, up, 1 - tenth_to(k)), ball) == "2 general o");
  }
}

TEST_CASE("equations: a sphere in a bore") {
  const auto bore = [](const Rational& radius, const Rational& aside = 0) {
    return census(S::cylinder({aside, 0, 0}, oblique, radius), S::sphere(Rational(1, 3) * oblique, 1));
  };
  CHECK(bore(1) == "1 circle o *2");
  for (const int k : near) {
    CHECK(bore(1 + tenth_to(k)) == nothing);
    CHECK(bore(1 - tenth_to(k)) == "2 circle o");
  }
}

TEST_CASE("equations: two spheres") {
  const auto pair = [](const Rational& distance) {
    return census(S::sphere(origin, 1), S::sphere(distance * oblique, Length::of_squared(3)));
  };
  CHECK(pair(1) == "1 circle o");
  CHECK(census(S::sphere(origin, 1), S::sphere({2, 0, 0}, 1)) == "1 touch");
  CHECK(census(S::sphere(origin, 1), S::sphere({1, 0, 0}, 2)) == "1 touch");
  CHECK(census(S::sphere(origin, 1), S::sphere(origin, 2)) == nothing);
  CHECK(census(S::sphere(origin, 1), S::sphere(origin, 1)) == "same");
  for (const int k : near) {
    CHECK(census(S::sphere(origin, 1), S::sphere({2 + tenth_to(k), 0, 0}, 1)) == nothing);
    CHECK(census(S::sphere(origin, 1), S::sphere({2 - tenth_to(k), 0, 0}, 1)) == "1 circle o");
  }
}

TEST_CASE("equations: cones with other quadrics") {
  const S cone = S::cone(origin, up, 1), both = S::cone(origin, up, 1, 2);
  CHECK(census(cone, S::cylinder(origin, up, 1)) == "1 circle o");
  CHECK(census(both, S::cylinder(origin, up, 1)) == "2 circle o");
  CHECK(census(cone, S::sphere(origin, 1)) == "1 circle o");
  CHECK(census(cone, S::sphere({0, 0, -1}, 1)) == "1 touch");
  CHECK(census(cone, S::sphere({0, 0, 2}, Length::of_squared(2))) == "1 circle o *2");
  CHECK(census(cone, S::sphere({0, 0, 1}, 1)) == "1 circle o, 1 touch");
  CHECK(census(cone, cone) == "same");
  CHECK(census(cone, S::cone(origin, {0, 0, -5}, 1)) == "1 touch");
  CHECK(census(cone, S::cone(origin, {0, 0, -5}, 1, 2)) == "same");
  CHECK(census(cone, S::cone(origin, up, 2)) == "1 touch");
  CHECK(census(cone, S::cone({0, 0, 2}, {0, 0, -1}, 1)) == "1 circle o");
  // One sphere, of radius 1 about the origin, touches both: x^2 + y^2 = 1, and a cone of apex (2,0,0).
  CHECK(census(S::cylinder(origin, up, 1), S::cone({2, 0, 0}, right, Length::of_squared(Rational(1, 3)),
                                                   2)) == "2 ellipse o, 2 crossing");
  // Translated along a generator: a line of contact, and nothing else.
  CHECK(census(both, S::cone({1, 0, 1}, up, 1, 2)) == "1 line *2, 2 cut, 2 singular");
  CHECK(census(both, S::cone({2, 0, 0}, up, 1, 2)) == "1 hyperbola, 4 cut");
  // Four common lines through the apex.
  CHECK(census(S::cone(origin, up, 2, 2), S::cone(origin, right, 2, 2)) == "4 line, 1 crossing, 8 cut");
  // x^2 + y^2 = z^2 and y^2 + z^2 = x^2 is y^2 = 0 and x^2 = z^2, in both directions of the axis irrational.
  CHECK(census(both, S::cone(origin, right, 1, 2)) == "2 line *2, 1 crossing, 4 cut");
  CHECK(census(both, S::cone(origin, {1, 0, 2}, 1, 2)) == "2 line, 1 crossing, 4 cut");
  CHECK(census(cone, S::cone(origin, {1, 0, 2}, 1)) == "2 line, 2 cut, 1 singular");
}

TEST_CASE("equations: planes and a torus") {
  const S torus = S::torus(origin, up, 5, 3);
  CHECK(census(torus, S::plane(origin, up)) == "2 circle o");
  CHECK(census(torus, S::plane({0, 0, 3}, up)) == "1 circle o *2");
  CHECK(census(torus, S::plane(origin, right)) == "2 circle o");
  CHECK(census(torus, S::plane(origin, {3, 0, 4})) == "2 circle o, 2 crossing");
  // The centres are conjugate: sin^2 = 1/3 of the angle to the equator's plane, tan^2 = 1/2.
  CHECK(census(S::torus(origin, up, Length::of_squared(3), Length::of_squared(1)),
               S::plane(origin, {1, 1, 2})) == "2 circle o, 2 crossing");
  CHECK(census(torus, S::plane({2, 0, 0}, right)) == "1 general o, 1 crossing");
  CHECK(census(torus, S::plane({8, 0, 0}, right)) == "1 touch");
  for (const int k : near) {
    CHECK(census(torus, S::plane({0, 0, 3 + tenth_to(k)}, up)) == nothing);
    CHECK(census(torus, S::plane({0, 0, 3 - tenth_to(k)}, up)) == "2 circle o");
    CHECK(census(torus, S::plane({2 + tenth_to(k), 0, 0}, right)) == general);
    CHECK(census(torus, S::plane({2 - tenth_to(k), 0, 0}, right)) == "2 general o");
    CHECK(census(torus, S::plane(origin, {3 + tenth_to(k), 0, 4})) == "2 general o");
  }
}

TEST_CASE("equations: circles of Villarceau that two tori share") {
  // A torus turned about the axis of one of its circles of Villarceau, by 3/5 and 4/5, in the planes 3x = 4z.
  const Point n = Rational(1, 5) * Point{3, 0, 4}, centre = {0, 3, 0};
  const auto turned = [&](const Point& q) {
    const Rational c(3, 5), s(4, 5);
    return c * q + s * cross(n, q) + (1 - c) * dot(n, q) * n;
  };
  const S torus = S::torus(origin, up, 5, 3), other = S::torus(centre - turned(centre), turned(up), 5, 3);
  const SurfaceIntersection shared = intersect(torus, other);
  REQUIRE(shared.status == Status::complete);
  REQUIRE(shared.count(SpaceCurveKind::circle) == 1);
  for (const SpaceCurve& curve : shared.curves)
    if (curve.kind == SpaceCurveKind::circle) {
      CHECK(*curve.point == centre);
      CHECK(*curve.radius_squared == 25);
      CHECK(is_zero(cross(*curve.direction, n)));
      CHECK(curve.is_closed);
    }
  CHECK(census(torus, other).starts_with("1 circle o, "));
}

TEST_CASE("equations: a torus and quadrics") {
  const S torus = S::torus(origin, up, 5, 3);
  CHECK(census(torus, S::cylinder(origin, up, 8)) == "1 circle o *2");
  CHECK(census(torus, S::cylinder(origin, up, 2)) == "1 circle o *2");
  CHECK(census(torus, S::cylinder(origin, up, 5)) == "2 circle o");
  CHECK(census(torus, S::sphere({5, 0, 0}, 3)) == "1 circle o *2");
  CHECK(census(torus, S::sphere(origin, 2)) == "1 circle o *2");
  CHECK(census(torus, S::sphere(origin, 5)) == "2 circle o");
  CHECK(census(torus, S::sphere({10, 0, 0}, 2)) == "1 touch");
  CHECK(census(torus, S::cylinder(origin, right, 1)) == "4 general o");
  // Along a tangent of the circle in the middle, of the radius of the tube: contact along a circle.
  CHECK(census(torus, S::cylinder({5, 0, 0}, {0, 1, 0}, 3)) == "1 circle o *2, 1 general o, 2 crossing");
  for (const int k : near) {
    CHECK(census(torus, S::cylinder(origin, up, 8 + tenth_to(k))) == nothing);
    CHECK(census(torus, S::cylinder(origin, up, 8 - tenth_to(k))) == "2 circle o");
  }
}

TEST_CASE("equations: two tori about one axis") {
  const auto pair = [](const Rational& major, const Rational& minor, const Rational& shift,
                       const Point& axis = {2, 2, 1}) {
    return census(S::torus(origin, axis, 5, 3),
                  S::torus(shift / 3 * axis, Rational(-2) * axis, major, minor));
  };
  CHECK(pair(5, 3, 0) == "same");
  CHECK(pair(5, 2, 0) == nothing);
  CHECK(pair(5, 3, 4) == "2 circle o");
  CHECK(pair(7, 3, 0) == "2 circle o");
  CHECK(pair(5, 3, 6) == "1 circle o *2");
  CHECK(pair(9, 1, 0) == "1 circle o *2");
  CHECK(pair(7, 1, 0) == "1 circle o *2");
  CHECK(pair(8, 2, 4) == "1 circle o *2");  // the centres are 5 apart
  CHECK(pair(8, 3, 4) == "2 circle o");
  CHECK(pair(20, 1, 0) == nothing);
  for (const int k : near) {
    CHECK(pair(8, 2 + tenth_to(k), 4) == "2 circle o");
    CHECK(pair(8, 2 - tenth_to(k), 4) == nothing);
    CHECK(pair(8 + tenth_to(k), 2, 4) == nothing);
    CHECK(pair(8, 2, 4 - tenth_to(k)) == "2 circle o");
    CHECK(pair(5, 3 - tenth_to(k), 0) == nothing);
    CHECK(pair(5, 3, tenth_to(k)) == "2 circle o");
  }
  // Radii of rational ratio, and an axis without rational points.
  const auto root = [](const Rational& q) { return Length::of_squared(q); };
  CHECK(census(S::torus(origin, oblique, root(12), root(3)), S::torus(oblique, oblique, root(12), root(3))) ==
        "2 circle o");
  CHECK(census(S::torus(origin, oblique, root(12), root(3)), S::torus(origin, oblique, root(48), root(3))) ==
        "1 circle o *2");
  const SurfaceIntersection touching =
      intersect(S::torus(origin, up, 5, 3), S::torus({0, 0, 4}, up, 8, 2), coarse());
  REQUIRE(touching.curves.size() == 1);  // three fifths of the way from (5,0) to (8,4)
  CHECK(*touching.curves[0].point == Point{0, 0, Rational(12, 5)});
  CHECK(*touching.curves[0].radius_squared == Rational(34, 5) * Rational(34, 5));
}

TEST_CASE("equations: a plane and polynomials") {
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                        z = SpacePolynomial::variable(2), one = SpacePolynomial::constant(1);
  const S level = S::plane(origin, up);
  CHECK(census(level, S::polynomial(x * x * x * x + y * y * y * y - one)) == general);
  CHECK(census(level, S::polynomial(x * x + y * y + z - one)) == "1 circle o");
  CHECK(census(level, S::polynomial(x * y - one + z)) == "1 hyperbola, 4 cut");
  CHECK(census(level, S::polynomial(y - x * x + z * x)) == "1 parabola, 2 cut");
  CHECK(census(level, S::polynomial(x * y * (x + y) + z)) == "3 line, 1 crossing, 6 cut");
  CHECK(census(level, S::polynomial(x * x * (y - one))) == "1 line, 1 line *2, 1 crossing, 4 cut");
  CHECK(census(level, S::polynomial(y * y - x * x * x)) == "1 general, 2 cut, 1 singular");
  CHECK(census(level, S::polynomial(y * y - x * x * (x + one))) == "1 general, 1 crossing, 2 cut");
  CHECK(census(level, S::polynomial(y * y - x * x * (x - one))) == "1 general, 2 cut, 1 touch");
  CHECK(census(level, S::polynomial(z + one)) == nothing);
  CHECK(census(level, S::polynomial(z * x)) == "same");
  // Of two branches x -> +-oo beside each other, and of an oval: y^2 = x^3 - 3x + 2 + e for small e.
  const auto cubic = [&](const Rational& e) {
    return census(level, S::polynomial(y * y - x * x * x + Rational(3) * x + (-2 - e) * one));
  };
  CHECK(cubic(0) == "1 general, 1 crossing, 2 cut");
  for (const int k : near) {
    CHECK(cubic(tenth_to(k)) == "1 general, 2 cut");
    CHECK(cubic(-tenth_to(k)) == "1 general, 1 general o, 2 cut");
  }
  // Planes with the quadrics that polynomials are, at several sizes; their curves have the same names.
  for (const Rational& q : {Rational(1, 1000), Rational(127, 5), Rational(100000000)}) {
    const S cone = S::cone(origin, up, 1, 2), tube = S::cylinder({q, 0, 0}, {1, 2, 3}, Length(q));
    for (const Point& normal : {up, Point{1, 0, 2}, Point{1, 0, 1}, Point{3, 1, 1}})
      for (const S& other : {cone, tube}) {
        const S plane = S::plane({q, 2 * q, q}, normal);
        CHECK(census(plane, S::polynomial(other.equation())) == census(plane, other));
      }
    const S torus = S::torus(origin, up, Length(Rational(5 * q)), Length(Rational(3 * q)));
    const S skew = S::plane({0, 0, q}, {1, 2, 3});
    CHECK(census(skew, S::polynomial(torus.equation())) == census(skew, torus));
    const SurfaceIntersection drawn = intersect(skew, S::polynomial(torus.equation()), coarse());
    for (const SpaceArc& arc : drawn.arcs) CHECK(arc.error_bound < 0.1 * to_double(q));
  }
}

TEST_CASE("equations: sizes and places that doubles hardly hold") {
  // Moved by c and scaled by q, pairs have the same curves, at places that follow exactly.
  const Point c = {0, 1, 2};
  for (const int exponent : {-1400, -300, 0, 900}) {
    const Rational q = power_of_two(exponent);
    for (const Point& at : {origin, power_of_two(exponent < 0 ? exponent + 60 : 0) * c}) {
      const S ball = S::sphere(at, Length(Rational(2 * q)));
      const S bore = S::cylinder(at + q * right, up, Length(q));
      CHECK(census(ball, bore) == census(S::sphere(origin, 2), S::cylinder(right, up, 1)));
      const SurfaceIntersection cut = intersect(S::plane(at + q * up, up), ball, coarse());
      REQUIRE(census(cut) == "1 circle o");
      CHECK(*cut.curves[0].point == at + q * up);
      CHECK(*cut.curves[0].radius_squared == 3 * q * q);
      for (const SpaceNode& node : cut.nodes)
        CHECK((node.box[2].lower <= at[2] + q && at[2] + q <= node.box[2].upper));
      const double place = 0x1p-48 * to_double(at[2]) + 0x1p-1060;
      for (const SpaceArc& arc : cut.arcs) CHECK(arc.error_bound <= 0.02 * to_double(q) + place);
    }
  }
  // The point that is given of a plane may be anywhere on it.
  CHECK(census(S::plane({power_of_two(1400), 0, Rational(1, 2)}, up), S::sphere(origin, 1)) == "1 circle o");
  const S huge = S::sphere(origin, Length(power_of_two(1100)));
  CHECK_THROWS_AS(intersect(huge, S::plane(origin, up)), BeyondDoubles);
  CHECK_THROWS_AS(intersect(huge, S::polynomial(S::plane(origin, up).equation())), BeyondDoubles);
  CHECK(census(huge, S::sphere(origin, 1)) == nothing);
}

}  // namespace exsect::intersect_equations_test
