#include "trace/enclose.h"

#include "answer/model_scale.h"
#include "side/boundary_lines.h"
#include "support/known_curves.h"

namespace exsect::enclose_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

template <class Ball>
void check_points(const std::vector<CertifiedPoint>& points, const Rational& width) {
  for (const CertifiedPoint& point : points) {
    const BallPoint<Ball> balls = enclose<Ball>(point, width);
    const ParameterBox finer = point.refined_to(width / 1024).box();
    for (std::size_t j = 0; j < 4; ++j) {
      const RationalInterval at = balls[j].interval();
      // The point is in the finer box and in the ball, so that they meet.
      CHECK(at.lower <= finer[j].upper);
      CHECK(finer[j].lower <= at.upper);
      CHECK(at.width() <= 2 * width + power_of_two(-45));
    }
  }
}

}  // namespace

TEST_CASE("enclose: irrational boundary points as balls of any width", "[trace]") {
  // (u - 1/2)^2 + (v - 1/2)^2 = 1/3 leaves the square in irrational points; two are on v = 0: u = 1/2 +-
  // 1/sqrt(12).
  const HeightCoefficients h = {{{q(1, 6), -1, 1}, {-1, 0, 0}, {1, 0, 0}}};
  const BezierPatch x = graph_patch(h), y = plane_patch();
  const BoundaryLines sides = boundary_lines(x, y, model_scale(x, y), 1e-6, {});
  REQUIRE(sides.points.size() == 8);
  for (const long bits : {10L, 30L, 50L}) check_points<DoubleBall>(sides.points, power_of_two(-bits));
  for (const long bits : {50L, 200L}) check_points<ArbBall<256>>(sides.points, power_of_two(-bits));
  std::size_t found = 0;
  for (const CertifiedPoint& point : sides.points) {
    const BallPoint<ArbBall<256>> at = enclose<ArbBall<256>>(point, power_of_two(-200));
    const ArbBall<256> from_middle = at[0] - ArbBall<256>(0.5);
    if (encloses(at[1], 0) && encloses(from_middle * from_middle, q(1, 12))) ++found;
  }
  CHECK(found == 2);
}

}  // namespace exsect::enclose_test
