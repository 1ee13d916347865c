#include "trace/tube_prediction.h"

#include <cmath>

#include "support/ball_checks.h"
#include "support/catch.h"
#include "support/graph_patches.h"

namespace exsect::tube_prediction_test {
namespace {

/// The distance from (u - 1/2)^2 + (v - 1/2)^2 = 1/9 of what is predicted from its highest point, over u.
template <class Ball>
double error(double tau) {
  testing::HeightCoefficients h{};
  h[0][0] = Rational(7, 18);
  h[1][0] = h[0][1] = -1;
  h[2][0] = h[0][2] = 1;
  const PairSystem<Ball> system(testing::graph_patch(h), testing::plane_patch(), {0, 0, 0}, 0);
  const Rational half(1, 2), top(5, 6);
  const auto found = predicted(system, testing::ball_point<Ball>({half, top, half, top}), 0, tau);
  REQUIRE(found);
  CHECK((*found)[0].approximation() == Approx(0.5 + tau));
  return std::fabs((*found)[1].approximation() - 0.5 - std::sqrt(1.0 / 9 - tau * tau));
}

}  // namespace

TEST_CASE("tube prediction: an error of the order after that of the line", "[trace]") {
  // v = 1/2 + sqrt(1/9 - t^2) is even: degree 3 leaves t^4, with the factor 27/8.
  CHECK(error<DoubleBall>(0.01) == Approx(27.0 / 8 * 1e-8).epsilon(0.02));
  CHECK(error<DoubleBall>(0.02) == Approx(27.0 / 8 * 16e-8).epsilon(0.02));
  // Degree 6 leaves t^8, degree 12 t^14: below the rounding of this comparison.
  CHECK(error<DoubleDoubleBall>(0.01) < 1e-12);
  CHECK(error<ArbBall<256>>(0.03) < 1e-14);
}

TEST_CASE("tube prediction: none where the curve is singular", "[trace]") {
  testing::HeightCoefficients h{};  // (u - 1/2)(v - 1/2)
  h[0][0] = Rational(1, 4);
  h[1][0] = h[0][1] = Rational(-1, 2);
  h[1][1] = 1;
  const PairSystem<DoubleBall> system(testing::graph_patch(h), testing::plane_patch(), {0, 0, 0}, 0);
  CHECK_FALSE(predicted(system, BallPoint<DoubleBall>{0.5, 0.5, 0.5, 0.5}, 0, 0.01));
}

}  // namespace exsect::tube_prediction_test
