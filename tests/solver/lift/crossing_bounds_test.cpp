// Bounds on a circle.
#include "lift/crossing_bounds.h"

#include "support/catch.h"

namespace exsect::crossing_bounds_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                      z = SpacePolynomial::variable(2), one = SpacePolynomial::constant(1);

SurfaceRegion bounded_by(const SpacePolynomial& form) { return {{{"side", form, one}}, {{0}}}; }

}  // namespace

TEST_CASE("crossing bounds: norms and signs on a circle") {
  const SpacePolynomial ball = x * x + y * y + z * z - Rational(25) * one, plane = z - Rational(3) * one;
  const auto projection = space_projection(ball, plane, general_frame(0));
  REQUIRE(projection);
  const auto branches = crossing_branches(ball, plane, *projection);
  REQUIRE(branches);
  const SpaceFrame frame = general_frame(0);
  for (const SpacePolynomial& form : {x - Rational(4) * one, y * y - Rational(7) * x, x + y + z}) {
    const auto bounds = crossing_bounds(*branches, bounded_by(form));
    REQUIRE(bounds.size() == 1);
    for (const Point& p : {Point{4, 0, 3}, Point{0, -4, 3}, Point{Rational(16, 5), Rational(12, 5), 3}}) {
      const Rational u = dot(frame.height, p), v = dot(cross(frame.columns[2], frame.columns[0]), p);
      CHECK(sign(bounds[0].below(u, v)) == sign(form(p)));
      if (form(p) == 0) {
        CHECK(bounds[0].norms[0](u) == 0);
      }
    }
  }
  for (const SpacePolynomial& form : {plane * x, ball})
    CHECK(crossing_bounds(*branches, bounded_by(form)).at(0).norms.at(0).is_zero());
}

TEST_CASE("crossing bounds: clauses") {
  const SurfaceRegion region{{{"a", x, one}, {"b", y, one}, {"c", z, one}}, {{0, 1}, {2}}};
  CHECK(is_in_region(region, {1, -1, 0}));
  CHECK(is_in_region(region, {-1, 0, 1}));
  CHECK(!is_in_region(region, {-1, -1, 1}));
  CHECK(!is_in_region(region, {1, 1, -1}));
  CHECK(is_in_region({}, {}));
}

}  // namespace exsect::crossing_bounds_test
