// Points with two rational parameters on one patch: against exact families, substitution, and line queries.
#include "line/half_rational_point.h"

#include <exsect/solver/line_patch.h>

#include "support/catch.h"
#include "support/families.h"
#include "support/random_pairs.h"

namespace exsect::half_rational_point_test {

TEST_CASE("a node with irrational parameters on one patch", "[half_rational_point]") {
  const Rational half(1, 2);
  for (const bool exchanged : {false, true}) {
    for (const ExactCase& c :
         {families::cap(0, families::Plane::quadratic), families::crossing(families::Plane::quadratic)}) {
      const BezierPatch& x = exchanged ? c.y : c.x;
      const BezierPatch& y = exchanged ? c.x : c.y;
      const auto points = half_rational_points(x, y, !exchanged, {half, half});
      REQUIRE(points.size() == 1);  // r + r² = 1 has one root in [0,1]
      CHECK(points[0].singular());
      const ParameterBox box = points[0].point.refined_to(power_of_two(-100)).box();
      const RationalInterval& r = box[exchanged ? 0 : 2];
      CHECK(r.lower * r.lower + r.lower < 1);
      CHECK(r.upper * r.upper + r.upper > 1);
      CHECK(box[exchanged ? 2 : 0].width() == 0);
      CHECK(points[0].point.sides().empty());
    }
  }
}

TEST_CASE("components of the tangent vanish one by one", "[half_rational_point]") {
  // (u, v, v - 1/2 - (u - 1/2)²) and (r, s (1 + r), 0): at u = v = r = 1/2, s = 1/3 the curve runs along u,
  // and only v turns, since v = s (1 + r).
  ControlNet graph;
  graph[0][0] = {0, 0, Rational(-3, 4)};
  graph[1][0] = {1, 0, 1};
  graph[2][0] = {0, 0, -1};
  graph[0][1] = {0, 1, 1};
  ControlNet plane;
  plane[1][0] = {1, 0, 0};
  plane[0][1] = plane[1][1] = {0, 1, 0};
  const BezierPatch x = BezierPatch::from_power_basis(graph);
  const BezierPatch y = BezierPatch::from_power_basis(plane);
  const Rational half(1, 2);
  const auto zero = [](const BezierPatch& a, const BezierPatch& b, bool of_a, const Rational& p,
                       const Rational& q) {
    const auto points = half_rational_points(a, b, of_a, {p, q});
    REQUIRE(points.size() == 1);
    CHECK_FALSE(points[0].singular());
    return points[0].tangent_is_zero;
  };
  CHECK(zero(x, y, true, half, half) == std::array{false, true, false, false});
  CHECK(zero(x, y, false, half, Rational(1, 3)) == std::array{false, true, false, false});
  CHECK(zero(y, x, false, half, half) == std::array{false, false, false, true});
  CHECK(zero(x.exchanged(), y.exchanged(), true, half, half) == std::array{true, false, false, false});
  CHECK(zero(y.exchanged(), x.exchanged(), true, Rational(1, 3), half) ==
        std::array{false, false, true, false});
}

TEST_CASE("regular points, sides, and none", "[half_rational_point]") {
  const ExactCase c = families::near_sheets(Rational(1, 4), families::Plane::square);
  const auto on_side = half_rational_points(c.x, c.y, true, {Rational(1, 4), 0});
  REQUIRE(on_side.size() == 1);
  CHECK_FALSE(on_side[0].singular());
  CHECK(on_side[0].point.sides() == std::vector<Side>{{Parameter::v, 0}, {Parameter::s, 0}});
  CHECK(half_rational_points(c.x, c.y, true, {Rational(1, 3), 0}).empty());
}

TEST_CASE("points on a line have no second rational parameter by chance", "[half_rational_point]") {
  const std::uint64_t seed = 11;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int i = 0; i < 10; ++i) {
    const auto pair = random_pairs::small_rationals(generator);
    const Rational u(1, 2);
    for (const CertifiedPoint& point : line_points(pair.x, pair.y, {Parameter::u, u}).points) {
      const Rational v = point.box()[1].midpoint();
      CHECK(half_rational_points(pair.x, pair.y, true, {u, v}).empty());
    }
    // y moved so that it passes through x(1/2,1/3) at (2/3,1/4): found, and transversal.
    const Point move = pair.x(u, Rational(1, 3)) - pair.y(Rational(2, 3), Rational(1, 4));
    ControlNet net = pair.y.net();
    for (auto& row : net)
      for (Point& p : row) p = p + move;
    const auto found = half_rational_points(pair.x, BezierPatch(net), true, {u, Rational(1, 3)});
    REQUIRE(found.size() == 1);
    CHECK_FALSE(found[0].singular());
    const ParameterBox box = found[0].point.refined_to(power_of_two(-80)).box();
    CHECK(box[2].lower <= Rational(2, 3));
    CHECK(box[2].upper >= Rational(2, 3));
    CHECK(box[3].lower <= Rational(1, 4));
    CHECK(box[3].upper >= Rational(1, 4));
  }
}

}  // namespace exsect::half_rational_point_test
