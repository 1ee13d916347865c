#include <exsect/algebra/ball.h>
#include <exsect/solver/line_patch.h>

#include "line_shapes.h"
#include "point_checks.h"
#include "support/catch.h"

namespace exsect::line_on_patch_test {

namespace {

void check_interval(const LinePoints& found, const Rational& from, const Rational& to) {
  REQUIRE(found.on_patch.size() == 1);
  CHECK(found.on_patch[0].from == RealAlgebraic(from));
  CHECK(found.on_patch[0].to == RealAlgebraic(to));
  CHECK(!found.incomplete);
}

/// A patch with y(0,s) = x(0, f(s)), f(s) = a + b s, otherwise its own.
BezierPatch neighbour(const BezierPatch& x, const Rational& a, const Rational& b) {
  const ControlNet c = x.power_basis();
  ControlNet d;
  for (auto& row : d) row.fill(Point{0, 0, 0});
  d[0][0] = c[0][0] + a * (c[0][1] + a * c[0][2]);
  d[0][1] = b * (c[0][1] + Rational(2 * a) * c[0][2]);
  d[0][2] = b * b * c[0][2];
  d[1][0] = {Rational(-1, 2), Rational(1, 7), Rational(1, 5)};
  d[1][1] = {Rational(1, 9), Rational(1, 8), Rational(-2, 5)};
  d[2][0] = {Rational(1, 11), 0, Rational(1, 3)};
  d[2][1] = {0, Rational(1, 6), Rational(1, 13)};
  d[2][2] = {Rational(1, 17), Rational(1, 19), Rational(1, 10)};
  return BezierPatch::from_power_basis(d);
}

}  // namespace

TEST_CASE("a shared edge is the whole line") {
  const BezierPatch x = example("chapter9-first.json").x;
  check_interval(line_points(x, neighbour(x, 0, 1), {Parameter::u, 0}), 0, 1);
  INFO("reversed");
  check_interval(line_points(x, neighbour(x, 1, -1), {Parameter::u, 0}), 0, 1);
  INFO("the other patch's line");
  check_interval(line_points(x, neighbour(x, 0, 1), {Parameter::r, 0}), 0, 1);
  check_interval(line_points(neighbour(x, 0, 1).exchanged(), x, {Parameter::v, 0}), 0, 1);
}

TEST_CASE("a part of the line is shared") {
  const BezierPatch x = example("chapter9-first.json").x;
  check_interval(line_points(x, neighbour(x, Rational(1, 3), Rational(5, 12)), {Parameter::u, 0}),
                 Rational(1, 3), Rational(3, 4));
  check_interval(line_points(x, neighbour(x, Rational(3, 4), Rational(-5, 12)), {Parameter::u, 0}),
                 Rational(1, 3), Rational(3, 4));
  INFO("the edge of y is longer than the line at one end");
  check_interval(line_points(x, neighbour(x, Rational(-1, 2), 1), {Parameter::u, 0}), 0, Rational(1, 2));
  check_interval(line_points(x, neighbour(x, Rational(-1, 2), 1), {Parameter::r, 0}), Rational(1, 2), 1);
}

TEST_CASE("the carriers agree but the arcs meet in one point") {
  const BezierPatch x = example("chapter9-first.json").x;
  const LinePoints found = line_points(x, neighbour(x, 1, 1), {Parameter::u, 0});
  CHECK(found.on_patch.empty());
  REQUIRE(found.points.size() == 1);
  CHECK(contains(found.points[0].box(), {0, 1, 0, 0}));
  CHECK(found.points[0].sides() ==
        std::vector<Side>{{Parameter::u, 0}, {Parameter::v, 1}, {Parameter::r, 0}, {Parameter::s, 0}});
  CHECK(line_points(x, neighbour(x, 2, 1), {Parameter::u, 0}).points.empty());
  CHECK(line_points(x, neighbour(x, 2, 1), {Parameter::u, 0}).on_patch.empty());
}

TEST_CASE("a line inside the other patch") {
  // y is x over a larger square: every line lies on it.
  const BezierPatch x = example("chapter9-first.json").x;
  const BezierPatch larger =
      x.restricted_to(Rational(-1, 3), Rational(4, 3), Rational(-1, 5), Rational(6, 5));
  check_interval(line_points(x, larger, {Parameter::u, Rational(2, 7)}), 0, 1);
  const BezierPatch smaller = x.restricted_to(Rational(1, 3), 1, Rational(1, 5), Rational(6, 7));
  check_interval(line_points(x, smaller, {Parameter::u, Rational(3, 7)}), Rational(1, 5), Rational(6, 7));
  check_interval(line_points(x, smaller, {Parameter::v, Rational(3, 7)}), Rational(1, 3), 1);
  CHECK(line_points(x, smaller, {Parameter::u, Rational(2, 7)}).on_patch.empty());
}

TEST_CASE("ends at algebraic numbers") {
  // The parabola (v, v^2, 0) in the plane of y = (r, s, 0): on y for v <= 1; y cut at (r, s/2): v^2 <= 1/2.
  const BezierPatch x = power_patch({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}}});
  const BezierPatch y = power_patch({{{0, 0, 0}, {0, Rational(1, 2), 0}}, {{1, 0, 0}}});
  const LinePoints found = line_points(x, y, {Parameter::u, 0});
  REQUIRE(found.on_patch.size() == 1);
  CHECK(found.on_patch[0].from == RealAlgebraic(0));
  const Polynomial t = Polynomial::variable();
  CHECK(sign_at(Polynomial(2) * t * t - Polynomial(1), found.on_patch[0].to) == 0);
  CHECK(found.points.empty());
  INFO("two pieces and a point: the parabola leaves the window and touches it again");
  const BezierPatch window = power_patch({{{0, Rational(1, 4), 0}, {0, 1, 0}}, {{1, 0, 0}}});
  const BezierPatch arc = power_patch({{{0, 1, 0}, {1, -4, 0}, {0, 4, 0}}, {{0, 0, 1}}});  // (v, (1-2v)^2)
  const LinePoints two = line_points(arc, window, {Parameter::u, 0});
  REQUIRE(two.on_patch.size() == 2);
  CHECK(two.on_patch[0].from == RealAlgebraic(0));
  CHECK(two.on_patch[0].to == RealAlgebraic(Rational(1, 4)));
  CHECK(two.on_patch[1].from == RealAlgebraic(Rational(3, 4)));
  CHECK(two.on_patch[1].to == RealAlgebraic(1));
  const BezierPatch below = power_patch({{{0, -1, 0}, {0, 1, 0}}, {{1, 0, 0}}});  // touches at (1/2, 0)
  const LinePoints touch = line_points(arc, below, {Parameter::u, 0});
  CHECK(touch.on_patch.empty());
  REQUIRE(touch.points.size() == 1);
  CHECK(contains(touch.points[0].box(), {0, Rational(1, 2), Rational(1, 2), 1}));
  CHECK(touch.points[0].sides() == std::vector<Side>{{Parameter::u, 0}, {Parameter::s, 1}});
}

TEST_CASE("straight and folded lines on a plane patch") {
  const BezierPatch y = power_patch({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}}});  // (r, s, 0)
  INFO("straight");
  const BezierPatch straight = power_patch({{{Rational(1, 2), -1, 0}, {0, 3, 0}}, {{0, 0, 1}}});
  check_interval(line_points(straight, y, {Parameter::u, 0}), Rational(1, 3), Rational(2, 3));
  INFO("folded: (1/2, 2 v (1-v) - 1/4, 0) is in the square while 2 v (1-v) >= 1/4");
  const BezierPatch folded =
      power_patch({{{Rational(1, 2), Rational(-1, 4), 0}, {0, 2, 0}, {0, -2, 0}}, {{0, 0, 1}}});
  const LinePoints found = line_points(folded, y, {Parameter::u, 0});
  REQUIRE(found.on_patch.size() == 1);
  const Polynomial t = Polynomial::variable();
  const Polynomial ends = Polynomial(2) * t * (Polynomial(1) - t) - Polynomial(Rational(1, 4));
  CHECK(sign_at(ends, found.on_patch[0].from) == 0);
  CHECK(sign_at(ends, found.on_patch[0].to) == 0);
  CHECK(found.on_patch[0].from < found.on_patch[0].to);
  INFO("the turn of the fold just reaches the square");
  const BezierPatch turn = power_patch({{{Rational(1, 2), -1, 0}, {0, 4, 0}, {0, -4, 0}}, {{0, 0, 1}}});
  const LinePoints touch = line_points(turn, y, {Parameter::u, 0});
  CHECK(touch.on_patch.empty());
  REQUIRE(touch.points.size() == 1);
  CHECK(contains(touch.points[0].box(), {0, Rational(1, 2), Rational(1, 2), 0}));
  INFO("and both ends only");
  const BezierPatch dip = power_patch({{{Rational(1, 2), 0, 0}, {0, -4, 0}, {0, 4, 0}}, {{0, 0, 1}}});
  const LinePoints both = line_points(dip, y, {Parameter::u, 0});
  CHECK(both.on_patch.empty());
  REQUIRE(both.points.size() == 2);
  CHECK(both.points[0].on({Parameter::v, 0}));
  CHECK(both.points[1].on({Parameter::v, 1}));
}

TEST_CASE("a line that is one point") {
  const BezierPatch x = power_patch({{{Rational(1, 2), Rational(1, 3), 0}}, {{0, 0, 1}, {0, 1, 0}}});
  const BezierPatch y = power_patch({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}}});
  const LineIntersection on = intersect_line(x, y, {Parameter::u, 0});
  CHECK(on.shape == LineShape::point);
  check_interval(on.solution, 0, 1);
  const BezierPatch off = power_patch({{{Rational(1, 2), Rational(4, 3), 0}}, {{0, 0, 1}, {0, 1, 0}}});
  CHECK(line_points(off, y, {Parameter::u, 0}).on_patch.empty());
}

TEST_CASE("a collapsed side of y on the line is one parameter") {
  // y(r,0) is the point (1/2, 1/4, 0) of the parabola (v, v^2, 0) for every r.
  const BezierPatch x = power_patch({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}}});
  const BezierPatch y =
      power_patch({{{Rational(1, 2), Rational(1, 4), 0}, {0, 0, 1}}, {{0, 0, 0}, {1, 0, 0}}});
  check_interval(line_points(x, y, {Parameter::u, 0}), Rational(1, 2), Rational(1, 2));
}

TEST_CASE("a patch degenerated to a curve that is the line") {
  const BezierPatch x = power_patch({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}}});
  // y(r,s) = the point of the parabola at (r + s)/2 + 1/4
  const Rational h(1, 2);
  const Rational q(1, 4);
  const BezierPatch y =
      power_patch({{{q, q * q, 0}, {h, q, 0}, {0, q, 0}}, {{h, q, 0}, {0, h, 0}}, {{0, q, 0}}});
  check_interval(line_points(x, y, {Parameter::u, 0}), Rational(1, 4), 1);
}

}  // namespace exsect::line_on_patch_test
