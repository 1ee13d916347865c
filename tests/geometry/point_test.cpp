#include <exsect/geometry/point.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::point_test {

TEST_CASE("products of vectors obey their laws", "[point]") {
  const Point ex = {1, 0, 0};
  const Point ey = {0, 1, 0};
  const Point ez = {0, 0, 1};
  CHECK(cross(ex, ey) == ez);
  CHECK(cross(ey, ez) == ex);
  CHECK(determinant(ex, ey, ez) == 1);
  CHECK(determinant(ey, ex, ez) == -1);
  CHECK(is_zero(Point{0, 0, 0}));
  CHECK_FALSE(is_zero(Point{0, 0, Rational(1, 1000)}));
  const auto seed = 1u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 50; ++round) {
    const Point a = random_point(random);
    const Point b = random_point(random);
    const Point c = random_point(random);
    CHECK(dot(cross(a, b), a) == 0);
    CHECK(is_zero(cross(a, b) + cross(b, a)));
    CHECK(cross(a, cross(b, c)) == dot(a, c) * b - dot(a, b) * c);
    CHECK(dot(cross(a, b), cross(a, b)) == dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b));
    CHECK(determinant(a, b, c) == determinant(b, c, a));
    CHECK(determinant(a, b, Rational(2) * a - Rational(1, 3) * b) == 0);
  }
}

}  // namespace exsect::point_test
