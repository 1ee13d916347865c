#include <exsect/geometry/bounding_box.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::bounding_box_test {

TEST_CASE("closed boxes meet on their rims", "[bounding_box]") {
  const BoundingBox unit = {{0, 0, 0}, {1, 1, 1}};
  const Rational tiny = power_of_two(-200);
  CHECK(intersects(unit, unit));
  CHECK(intersects(unit, {{1, 0, 0}, {2, 1, 1}}));  // a face
  CHECK(intersects(unit, {{1, 1, 1}, {2, 2, 2}}));  // a corner
  CHECK_FALSE(intersects(unit, {{1 + tiny, 0, 0}, {2, 1, 1}}));
  CHECK_FALSE(intersects(unit, {{0, -1, 0}, {1, -tiny, 1}}));
  CHECK(intersects(unit, {{-1, -1, -1}, {2, 2, 2}}));  // inside
  CHECK(intersects(
      unit, {{Rational(1, 2), Rational(1, 2), -1}, {Rational(1, 2), Rational(1, 2), 2}}));  // a segment
  CHECK(unit.contains({1, 0, Rational(1, 2)}));
  CHECK_FALSE(unit.contains({1, 0, 1 + tiny}));
  CHECK(united(unit, {{2, -1, 0}, {3, 0, 0}}) == BoundingBox{{0, -1, 0}, {3, 1, 1}});
  CHECK(largest_extent({{0, -1, 0}, {3, 1, Rational(7, 2)}}) == Rational(7, 2));
  CHECK(largest_extent({{1, 1, 1}, {1, 1, 1}}) == 0);
}

TEST_CASE("the box of a patch is the tightest around its net and holds the patch", "[bounding_box]") {
  const auto seed = 27u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 10; ++round) {
    const BezierPatch x = random_patch(random);
    const BoundingBox box = bounding_box(x);
    for (std::size_t k = 0; k < 3; ++k) {
      int at_lower = 0;
      int at_upper = 0;
      for (const auto& row : x.net()) {
        for (const Point& p : row) {
          CHECK(box.contains(p));
          at_lower += p[k] == box.lower[k] ? 1 : 0;
          at_upper += p[k] == box.upper[k] ? 1 : 0;
        }
      }
      CHECK(at_lower > 0);
      CHECK(at_upper > 0);
    }
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; j <= 4; ++j) CHECK(box.contains(x(Rational(i, 4), Rational(j, 4))));
  }
}

}  // namespace exsect::bounding_box_test
