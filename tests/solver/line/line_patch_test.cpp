#include <exsect/algebra/ball.h>
#include <exsect/algebra/fixed_point_interval.h>
#include <exsect/algebra/sturm.h>
#include <exsect/solver/line_patch.h>

#include "line_shapes.h"
#include "point_checks.h"
#include "support/catch.h"

namespace exsect::line_patch_test {

namespace {

struct ReferenceLine {
  Rational u;
  int real_roots;
  int roots_in_unit_interval;
  std::vector<std::array<double, 3>> vrs;
};

}  // namespace

TEST_CASE("the lines of the chapter's first example") {
  const auto [x, y] = example("chapter9-first.json");
  const ReferenceLine line = GENERATE(
      ReferenceLine{Rational(1, 20), 6, 2, {{0.776448446389618, 0.107880802430024, 0.829059843609136}}},
      ReferenceLine{Rational(2, 25), 6, 1, {}},
      ReferenceLine{Rational(1, 2),
                    8,
                    3,
                    {{0.122377867125713, 0.507744326746548, 0.144958858226505},
                     {0.533658757928993, 0.665785302250363, 0.685689333102444}}});
  const LineIntersection result = intersect_line(x, y, {Parameter::u, line.u});
  CHECK(result.shape == LineShape::conic);
  CHECK(result.eliminant_variable == Parameter::s);
  CHECK(result.eliminant.degree() == 16);
  CHECK(SturmSequence(result.eliminant).count_all() == line.real_roots);
  CHECK(SturmSequence(result.eliminant).count_closed(0, 1) == line.roots_in_unit_interval);
  REQUIRE(result.solution.points.size() == line.vrs.size());
  CHECK(result.solution.on_patch.empty());
  CHECK(!result.solution.incomplete);
  for (std::size_t i = 0; i < line.vrs.size(); ++i) {
    const CertifiedPoint& p = result.solution.points[i];
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(to_double(p.box()[k + 1].midpoint()) == Approx(line.vrs[i][k]).margin(2e-15).epsilon(0));
    CHECK(p.box()[0].lower == line.u);
    CHECK(p.multiplicity() == 1);
    CHECK(p.sides().empty());
    check_point(x, y, p);
  }
  check_feasibility(result);
}

TEST_CASE("lines of all four parameters meet at the same point") {
  const auto [x, y] = example("chapter9-first.json");
  // A line through a rational approximation of a point must have a point nearby, whichever parameter is
  // fixed.
  const CertifiedPoint p = line_points(x, y, {Parameter::u, Rational(1, 2)}).points.at(0);
  for (const Parameter fixed : all_parameters) {
    const Rational value = simplest_between(p.box()[index(fixed)].midpoint() - power_of_two(-24),
                                            p.box()[index(fixed)].midpoint() + power_of_two(-24));
    const LinePoints found = line_points(x, y, {fixed, value});
    INFO(name(fixed));
    bool near_found = false;
    for (const CertifiedPoint& q : found.points) {
      check_point(x, y, q);
      double distance = 0;
      for (std::size_t i = 0; i < 4; ++i)
        distance = std::max(distance, std::abs(to_double(q.box()[i].midpoint() - p.box()[i].midpoint())));
      near_found = near_found || distance < 1e-4;
    }
    CHECK(near_found);
  }
}

TEST_CASE("exchanging the patches and their parameters renames the points") {
  const auto [x, y] = example("chapter9-first.json");
  const Rational c(1, 2);
  const LinePoints u = line_points(x, y, {Parameter::u, c});
  const std::vector<LinePoints> others = {
      line_points(x.exchanged(), y, {Parameter::v, c}), line_points(y, x, {Parameter::r, c}),
      line_points(y, x.exchanged(), {Parameter::s, c}), line_points(x, y.exchanged(), {Parameter::u, c})};
  const std::vector<std::array<std::size_t, 4>> names = {
      {1, 0, 2, 3}, {2, 3, 0, 1}, {3, 2, 0, 1}, {0, 1, 3, 2}};
  for (std::size_t k = 0; k < others.size(); ++k) {
    REQUIRE(others[k].points.size() == u.points.size());
    for (std::size_t i = 0; i < u.points.size(); ++i)
      for (std::size_t p = 0; p < 4; ++p) {
        const RationalInterval& a = u.points[i].box()[p];
        const RationalInterval& b = others[k].points[i].box()[names[k][p]];
        CHECK(a.lower <= b.upper);
        CHECK(b.lower <= a.upper);
      }
  }
}

TEST_CASE("a line that touches the patch") {
  const auto [x, y] = example("touching-curve.json");
  const LineIntersection result = intersect_line(x, y, {Parameter::u, Rational(1, 2)});
  const std::vector<PolynomialPower> factors = irreducible_factors(result.eliminant);
  REQUIRE(factors.size() == 2);
  CHECK(factors[0].factor.degree() == 14);
  CHECK(factors[1].factor == Polynomial(std::vector<Rational>{-1, 2}));
  CHECK(factors[1].multiplicity == 2);
  REQUIRE(result.solution.points.size() == 1);
  const CertifiedPoint& p = result.solution.points[0];
  CHECK(p.multiplicity() == 2);
  CHECK(contains(p.box(), {Rational(1, 2), Rational(1, 2), Rational(1, 2), Rational(1, 2)}));
  check_point(x, y, p);
  check_feasibility(result);
}

TEST_CASE("the ends of the touching curve lie on sides, exactly") {
  const auto [x, y] = example("touching-curve.json");
  const LinePoints at_one = line_points(x, y, {Parameter::u, Rational(1, 4)});
  REQUIRE(at_one.points.size() == 1);
  CHECK(at_one.points[0].sides() == std::vector<Side>{{Parameter::v, 1}});
  CHECK(contains(at_one.points[0].box(), {Rational(1, 4), 1, Rational(7, 24), Rational(11, 12)}));
  const LinePoints at_zero = line_points(x, y, {Parameter::v, 0});
  REQUIRE(at_zero.points.size() == 1);
  CHECK(at_zero.points[0].sides() == std::vector<Side>{{Parameter::v, 0}});
  CHECK(contains(at_zero.points[0].box(), {Rational(3, 4), 0, Rational(17, 24), Rational(1, 12)}));
}

TEST_CASE("patches that meet in a common corner only") {
  // The corner x(0,0) = y(0,0), the patches on different sides of a plane.
  const BezierPatch x = height_field({{0, 1, 0}, {1, 0, 1}});
  const BezierPatch y =
      power_patch({{{0, 0, 0}, {-1, 0, 1}, {0, 0, 1}}, {{0, -1, 1}, {0, 0, 1}}, {{0, 0, -1}}});
  for (const Parameter fixed : all_parameters) {
    const LinePoints found = line_points(x, y, {fixed, 0});
    REQUIRE(found.points.size() == 1);
    CHECK(found.points[0].sides() ==
          std::vector<Side>{{Parameter::u, 0}, {Parameter::v, 0}, {Parameter::r, 0}, {Parameter::s, 0}});
    CHECK(contains(found.points[0].box(), {0, 0, 0, 0}));
  }
}

TEST_CASE("a parameter outside [0,1] is refused") {
  const auto [x, y] = example("chapter9-first.json");
  CHECK_THROWS_AS(line_points(x, y, {Parameter::u, Rational(-1, 100)}), std::invalid_argument);
  CHECK_THROWS_AS(intersect_line(x, y, {Parameter::s, Rational(101, 100)}), std::invalid_argument);
}

}  // namespace exsect::line_patch_test
