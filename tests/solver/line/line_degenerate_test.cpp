// Fibres over one value of the eliminated parameter that are not generic: the leading coefficient vanishes,
// both roots of the plane are solutions, the plane is linear, constant or zero there.
#include <exsect/solver/line_patch.h>

#include "line_shapes.h"
#include "point_checks.h"
#include "support/catch.h"

namespace exsect::line_degenerate_test {

namespace {

const Rational half(1, 2);

/// The arc (v, 4 v (1-v), 0) at u = 0.
BezierPatch arc() { return power_patch({{{0, 0, 0}, {1, 4, 0}, {0, -4, 0}}, {{0, 0, 1}}}); }

/// (r, a + b r + c r^2 + d (s - 1/2), plane(r,s)): the plane of the arc pulls back to `plane` itself.
BezierPatch over_arc(const std::array<Rational, 4>& second, const BivariatePolynomial& plane) {
  ControlNet net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net[i][j] = {0, 0, plane.coefficient(static_cast<int>(i), static_cast<int>(j))};
  net[1][0][0] = 1;
  for (std::size_t i = 0; i < 3; ++i) net[i][0][1] = second[i];
  net[0][0][1] -= second[3] * half;
  net[0][1][1] = second[3];
  return BezierPatch::from_power_basis(net);
}

const BivariatePolynomial r = BivariatePolynomial::r();
const BivariatePolynomial from_middle = BivariatePolynomial::s() - BivariatePolynomial::constant(half);

BivariatePolynomial constant(const Rational& c) { return BivariatePolynomial::constant(c); }

LineIntersection solve(const BezierPatch& y) {
  const LineIntersection line = intersect_line(arc(), y, {Parameter::u, 0});
  CHECK(!line.solution.incomplete);
  for (const CertifiedPoint& p : line.solution.points) check_point(arc(), y, p);
  return line;
}

/// The points found in the box of the whole square at these (v = r, s).
void check_points(const LineIntersection& line, const std::vector<std::array<Rational, 2>>& expected) {
  REQUIRE(line.solution.points.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    CHECK(contains(line.solution.points[i].box(), {0, expected[i][0], expected[i][0], expected[i][1]}));
}

}  // namespace

TEST_CASE("both roots of the plane over one s") {
  // At s = 1/2: r = 1/4 and 3/4, where the arc has height 3/4.
  const BivariatePolynomial plane =
      from_middle + (r - constant(Rational(1, 4))) * (r - constant(Rational(3, 4)));
  const LineIntersection line = solve(over_arc({Rational(3, 4), 0, 0, 1}, plane));
  check_points(line, {{Rational(1, 4), half}, {Rational(3, 4), half}});
  // The normal a1 x a2 points down: P is -4 times `plane`.
  CHECK(line.solution.points[0].branch() == 2);
  CHECK(line.solution.points[1].branch() == 1);
  for (const CertifiedPoint& p : line.solution.points) CHECK(p.multiplicity() == 1);
  CHECK(sign_at(line.eliminant.derivative(), RealAlgebraic(half)) == 0);
}

TEST_CASE("the leading coefficient vanishes at a root or near it") {
  for (const Rational& shift : {Rational(0), Rational(1, 1000000000), Rational(-1, 1000000007)}) {
    // A = s - 1/2 - shift; at s = 1/2 the point r = 1/2, the top of the arc.
    const BivariatePolynomial plane =
        (from_middle - constant(shift)) * (r * r - constant(Rational(1, 4))) + r - constant(half);
    const LineIntersection line = solve(over_arc({1, 0, 0, 1}, plane));
    bool found = false;
    for (const CertifiedPoint& p : line.solution.points)
      if (contains(p.box(), {0, half, half, half})) {
        found = true;
        CHECK(p.branch() == 1);
      }
    CHECK(found);
    check_feasibility(line);
  }
}

TEST_CASE("a root of the plane at infinity only") {
  // A = s - 1/2, B = 0: at s = 1/2 the plane is 1/4 = 0.
  const LineIntersection line = solve(over_arc({1, 0, 0, 1}, from_middle * r * r + constant(Rational(1, 4))));
  for (const CertifiedPoint& p : line.solution.points) CHECK(p.box()[3].upper < half);
}

TEST_CASE("r runs free in the plane over one s") {
  const LineIntersection line = solve(over_arc({Rational(3, 4), 0, 0, 1}, from_middle * (r + constant(1))));
  check_points(line, {{Rational(1, 4), half}, {Rational(3, 4), half}});
  INFO("on the arc with r^2 as well: a parabola against a parabola, 3/4 + r/2 - r^2/2 = 4 r - 4 r^2");
  const LineIntersection other =
      solve(over_arc({Rational(3, 4), half, -half, 1}, from_middle * (r * r + r + constant(1))));
  CHECK(other.solution.points.size() == 2);
  INFO("and the line s = 1/2 of y is the arc");
  const LineIntersection shared = solve(over_arc({0, 4, -4, 1}, from_middle * (r * r + r + constant(1))));
  CHECK(shared.solution.points.empty());
  REQUIRE(shared.solution.on_patch.size() == 1);
  CHECK(shared.solution.on_patch[0].from == RealAlgebraic(0));
  CHECK(shared.solution.on_patch[0].to == RealAlgebraic(1));
}

TEST_CASE("the plane is constant or linear in r") {
  const LineIntersection constant_in_r = solve(over_arc({Rational(3, 4), 0, 0, 1}, from_middle));
  check_points(constant_in_r, {{Rational(1, 4), half}, {Rational(3, 4), half}});
  for (const CertifiedPoint& p : constant_in_r.solution.points) {
    CHECK(p.multiplicity() == 1);
    CHECK(p.branch() == 0);
  }
  INFO("the single root of a plane linear in r is branch 1, whatever the sign of B");
  const LineIntersection falling =
      solve(over_arc({Rational(3, 4), 0, 0, 1}, from_middle - r + constant(Rational(1, 4))));
  REQUIRE(!falling.solution.points.empty());
  for (const CertifiedPoint& p : falling.solution.points) CHECK(p.branch() == 1);
  const LineIntersection linear =
      solve(over_arc({Rational(3, 4), 0, 0, 1}, from_middle + r - constant(Rational(1, 4))));
  REQUIRE(!linear.solution.points.empty());
  bool found = false;
  for (const CertifiedPoint& p : linear.solution.points) {
    CHECK(p.branch() == 1);
    found = found || contains(p.box(), {0, Rational(1, 4), Rational(1, 4), half});
  }
  CHECK(found);
}

TEST_CASE("points close to a side are not on it, and their boxes stay in the square") {
  const Rational small = power_of_two(-60);
  const LineIntersection line = solve(over_arc({4 * small * (1 - small), 0, 0, 1}, from_middle));
  check_points(line, {{small, half}, {1 - small, half}});
  for (const CertifiedPoint& p : line.solution.points)
    CHECK(p.sides() == std::vector<Side>{{Parameter::u, 0}});
}

TEST_CASE("tangential points in the degenerate fibres") {
  INFO("the curve s = 1/2 touches the arc at its top");
  const LineIntersection touch = solve(over_arc({1, 0, 0, 1}, from_middle));
  check_points(touch, {{half, half}});
  CHECK(touch.solution.points[0].multiplicity() > 1);
  INFO("both branches of the plane meet at the point: D = 0, branch 0");
  const LineIntersection vertical =
      solve(over_arc({1, 0, 0, 1}, from_middle + (r - constant(half)) * (r - constant(half))));
  check_points(vertical, {{half, half}});
  CHECK(vertical.solution.points[0].branch() == 0);
}

TEST_CASE("y in the plane of the line: isolated and one-dimensional solutions") {
  // y = (r, s + 1/4, 0): 4 r (1-r) = s + 1/4.
  const LineIntersection line = solve(over_arc({Rational(3, 4), 0, 0, 1}, BivariatePolynomial()));
  REQUIRE(line.solution.on_patch.size() == 1);
  CHECK(sign_at(Polynomial(std::vector<Rational>{Rational(-1, 4), 4, -4}), line.solution.on_patch[0].from) ==
        0);
  CHECK(sign_at(Polynomial(std::vector<Rational>{Rational(-1, 4), 4, -4}), line.solution.on_patch[0].to) ==
        0);
  CHECK(line.solution.points.empty());
  CHECK(line.eliminant.is_zero());
  CHECK(line.feasible.empty());
  INFO("only the corner r = 0, s = 0 of y = (r - something) is on the arc");
  const BezierPatch corner = power_patch({{{half, 1, 0}, {0, 1, 0}}, {{1, 1, 0}}});
  const LinePoints at_corner = line_points(arc(), corner, {Parameter::u, 0});
  CHECK(at_corner.on_patch.empty());
  REQUIRE(at_corner.points.size() == 1);
  CHECK(at_corner.points[0].sides() ==
        std::vector<Side>{{Parameter::u, 0}, {Parameter::r, 0}, {Parameter::s, 0}});
}

TEST_CASE("an isolated real point of the shared curve") {
  // In the plane of the arc, y = (1/2 + a, 1 + b): on the arc where b = -4 a^2; a = (r - 1/2) + ..., and b
  // chosen so that b + 4 a^2 = (r-1/2)^2 + (s-1/2)^2 with a = s - 1/2: b = (r-1/2)^2 - 3 (s-1/2)^2.
  const BivariatePolynomial b =
      (r - constant(half)) * (r - constant(half)) - from_middle * from_middle * Polynomial(3);
  ControlNet net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net[i][j] = {0, b.coefficient(static_cast<int>(i), static_cast<int>(j)), 0};
  net[0][1][0] = 1;
  net[0][0][1] += 1;
  const BezierPatch y = BezierPatch::from_power_basis(net);
  const LinePoints found = line_points(arc(), y, {Parameter::u, 0});
  CHECK(found.on_patch.empty());
  REQUIRE(found.points.size() == 1);
  CHECK(contains(found.points[0].box(), {0, half, half, half}));
  CHECK(found.points[0].multiplicity() == 0);
  check_point(arc(), y, found.points[0]);
}

TEST_CASE("a straight line against the first example's patch") {
  const auto [x, y] = example("chapter9-first.json");
  // From below the patch to above it.
  const BezierPatch line = power_patch({{{half, half, 0}, {Rational(1, 20), 0, 1}}, {{1, 0, 0}}});
  const LineIntersection result = intersect_line(line, y, {Parameter::u, 0});
  CHECK(result.shape == LineShape::straight);
  CHECK(result.second.has_value());
  CHECK(result.eliminant.degree() == 8);
  REQUIRE(!result.solution.points.empty());
  for (const CertifiedPoint& p : result.solution.points) check_point(line, y, p);
  INFO("run through twice: every point at two values of v");
  const BezierPatch folded =
      power_patch({{{half, half, 0}, {Rational(1, 5), 0, 4}, {Rational(-1, 5), 0, -4}}, {{1, 0, 0}}});
  const LineIntersection twice = intersect_line(folded, y, {Parameter::u, 0});
  CHECK(twice.shape == LineShape::folded);
  REQUIRE(twice.solution.points.size() == 2 * result.solution.points.size());
  for (const CertifiedPoint& p : twice.solution.points) check_point(folded, y, p);
  for (std::size_t i = 0; i < twice.solution.points.size(); i += 2) {
    const Rational sum =
        twice.solution.points[i].box()[1].midpoint() + twice.solution.points[i + 1].box()[1].midpoint();
    CHECK(abs(sum - 1) < power_of_two(-45));
  }
}

}  // namespace exsect::line_degenerate_test
