#include <exsect/geometry/parameter_line.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::parameter_line_test {

TEST_CASE("parameter lines are the patch with one parameter fixed", "[parameter_line]") {
  const auto seed = 6u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 10; ++round) {
    const BezierPatch x = random_patch(random);
    for (const Rational& fixed : {Rational(0), Rational(1), Rational(2, 5), random_rational(random)}) {
      const ParameterLine along_v = line_at_first(x, fixed);
      const ParameterLine along_u = line_at_second(x, fixed);
      for (const Rational& t : {Rational(0), Rational(1), Rational(1, 3), Rational(-2)}) {
        CHECK(along_v(t) == x(fixed, t));
        CHECK(along_u(t) == x(t, fixed));
      }
    }
  }
}

TEST_CASE("the shape of a parameter line is exact", "[parameter_line]") {
  const Point zero = {0, 0, 0};
  const Point p = {1, -2, 3};
  const Point q = {Rational(1, 2), -1, Rational(3, 2)};
  const auto shape_of = [&](const Point& a1, const Point& a2) { return shape({{p, a1, a2}}); };
  CHECK(shape_of(zero, zero) == LineShape::point);
  CHECK(shape_of(p, zero) == LineShape::straight);
  CHECK(shape_of(zero, p) == LineShape::straight);  // turns at t = 0, an end
  CHECK(shape_of(p, q) == LineShape::straight);     // turns at t = -1
  CHECK(shape_of(p, Rational(-1) * p) == LineShape::folded);
  CHECK(shape_of(p, Rational(-1, 2) * p) == LineShape::straight);  // turns at t = 1, an end
  CHECK(shape_of(p, Rational(-50001, 100000) * p) == LineShape::folded);
  CHECK(shape_of(p, Rational(-49999, 100000) * p) == LineShape::straight);
  CHECK(shape_of(p, {1, -2, 4}) == LineShape::conic);
  CHECK(shape_of(p, {1, -2, 3 + power_of_two(-200)}) == LineShape::conic);
}

}  // namespace exsect::parameter_line_test
