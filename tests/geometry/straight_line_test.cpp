#include <exsect/geometry/straight_line.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::straight_line_test {

namespace {

std::vector<ParameterLine> straight_lines(Random& random) {
  const Point zero = {0, 0, 0};
  std::vector<ParameterLine> lines = {
      {{{zero, {1, 0, 0}, zero}}},                                   // along an axis
      {{{{1, 2, 3}, zero, {0, 0, -1}}}},                             // a1 = 0
      {{{zero, {1, 1, 1}, {-1, -1, -1}}}},                           // folded, closed: p(0) = p(1)
      {{{zero, {1, 1, 0}, {Rational(-1, 2), Rational(-1, 2), 0}}}},  // turns at the end
  };
  while (lines.size() < 20) {
    const Point direction = random_point(random);
    if (is_zero(direction)) continue;
    lines.push_back(
        {{random_point(random), random_rational(random) * direction, random_rational(random) * direction}});
    if (shape(lines.back()) == LineShape::point) lines.pop_back();
  }
  return lines;
}

}  // namespace

TEST_CASE("a straight line is a0 + phi(t) direction", "[straight_line]") {
  const auto seed = 25u;
  INFO("seed " << seed);
  Random random(seed);
  for (const ParameterLine& line : straight_lines(random)) {
    const StraightLine straight = straight_line(line);
    CHECK_FALSE(is_zero(straight.direction));
    CHECK(straight.phi.leading_coefficient() == 1);
    CHECK(straight.phi(0) == 0);
    CHECK(straight.phi.degree() == (is_zero(line.a[2]) ? 1 : 2));
    for (const Rational& t : {Rational(0), Rational(1), Rational(-3, 4), random_rational(random)})
      CHECK(line(t) == straight.a0 + straight.phi(t) * straight.direction);
  }
}

TEST_CASE("two orthogonal planes and lambda determine the point on the line", "[straight_line]") {
  const auto seed = 26u;
  INFO("seed " << seed);
  Random random(seed);
  for (const ParameterLine& line : straight_lines(random)) {
    const StraightForms forms = straight_forms(line);
    CHECK(dot(forms.first.normal, forms.second.normal) == 0);
    CHECK_FALSE(is_zero(cross(forms.first.normal, forms.second.normal)));
    CHECK_FALSE(determinant(forms.first.normal, forms.second.normal, forms.lambda.normal).is_zero());
    for (const Rational& t : {Rational(0), Rational(1), Rational(1, 3), random_rational(random)}) {
      const Point p = line(t);
      CHECK(forms.first(p) == 0);
      CHECK(forms.second(p) == 0);
      CHECK(forms.lambda(p) == forms.phi(t));
    }
  }
}

TEST_CASE("conics and points have no direction", "[straight_line]") {
  const Point zero = {0, 0, 0};
  const ParameterLine point = {{{{1, 2, 3}, zero, zero}}};
  const ParameterLine conic = {{{zero, {1, 0, 0}, {0, power_of_two(-300), 0}}}};
  for (const ParameterLine& line : {point, conic}) {
    CHECK_THROWS_AS(straight_line(line), std::domain_error);
    CHECK_THROWS_AS(straight_forms(line), std::domain_error);
  }
}

}  // namespace exsect::straight_line_test
