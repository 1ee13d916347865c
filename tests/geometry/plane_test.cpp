#include <exsect/geometry/plane.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::plane_test {

TEST_CASE("a form through a point vanishes there and measures along its normal", "[plane]") {
  const auto seed = 21u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 20; ++round) {
    const Point a0 = random_point(random);
    const Point n = random_point(random);
    const AffineForm form = form_through(a0, n);
    CHECK(form(a0) == 0);
    CHECK(form(a0 + n) == dot(n, n));
    CHECK(form(a0 + cross(n, random_point(random))) == 0);
  }
  CHECK(form_through({1, 2, 3}, {0, 0, 0}) == AffineForm{{0, 0, 0}, 0});
}

}  // namespace exsect::plane_test
