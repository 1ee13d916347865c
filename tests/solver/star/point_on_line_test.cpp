// Points at an algebraic parameter of a common line: against the exact solution.
#include "star/point_on_line.h"

#include "support/catch.h"
#include "support/families.h"

namespace exsect::point_on_line_test {
namespace {

/// The root 1/sqrt(2) of 2 t^2 - 1.
RealAlgebraic root_of_half() { return real_roots(Polynomial({-1, 0, 2}), 0, 1).front(); }

}  // namespace

TEST_CASE("points of a shared side over an algebraic parameter", "[point_on_line]") {
  // The neighbour runs through the side twice as fast, in the same direction: s = (v + 1/2) / 2 on r = 0.
  const ExactCase c = families::shared_side({Rational(-1, 2), Rational(3, 2), 0});
  const auto points = points_on_line(c.x, c.y, {Parameter::u, 0}, root_of_half());
  REQUIRE(points.size() == 1);
  CHECK(points[0].sides() == std::vector<Side>{{Parameter::u, 0}, {Parameter::r, 0}});
  for (const long bits : {50, 100, 200}) {
    const Rational width = power_of_two(-bits);
    const ParameterBox box = points[0].refined_to(width).box();
    const Rational v_low = box[1].lower;
    const Rational v_high = box[1].upper;
    CHECK(v_low * v_low * 2 <= 1);
    CHECK(v_high * v_high * 2 >= 1);
    CHECK(v_high - v_low <= width);
    const Rational s_low = 2 * box[3].lower - Rational(1, 2);
    const Rational s_high = 2 * box[3].upper - Rational(1, 2);
    CHECK(s_low * s_low * 2 <= 1);
    CHECK(s_high * s_high * 2 >= 1);
    CHECK(box[3].width() <= width);
    CHECK(box[0].width() == 0);
    CHECK(box[2].width() == 0);
  }
}

TEST_CASE("points of a shared side are known in the field of the parameter", "[point_on_line]") {
  const ExactCase c = families::shared_side({Rational(-1, 2), Rational(3, 2), 0});
  const auto points = points_on_line(c.x, c.y, {Parameter::u, 0}, root_of_half());
  REQUIRE(points.size() == 1);
  const auto exact = points[0].exact();
  REQUIRE(exact);
  CHECK(exact->at.s() == root_of_half());
  // 2 s - 1/2 = v
  const BivariatePolynomial difference =
      BivariatePolynomial::constant(2) * exact->numerator[3] -
      (BivariatePolynomial::constant(Rational(1, 2)) + exact->numerator[1]) * exact->denominator[3];
  CHECK(sign_at(difference, exact->at) == 0);
  CHECK(exact->numerator[0].is_zero());
  CHECK(exact->numerator[2].is_zero());
}

TEST_CASE("a line that is not on the patch has none, a side inside one", "[point_on_line]") {
  const ExactCase c = families::double_cover();
  const auto points = points_on_line(c.x, c.y, {Parameter::r, Rational(1, 3)}, root_of_half());
  CHECK(points.empty());
  const auto side = families::side_on_interior_line();
  const auto inside = points_on_line(side.x, side.y, {Parameter::u, Rational(1, 2)}, root_of_half());
  REQUIRE(inside.size() == 1);
  CHECK(inside[0].sides() == std::vector<Side>{{Parameter::r, 0}});
}

}  // namespace exsect::point_on_line_test
