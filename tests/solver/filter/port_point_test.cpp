#include "filter/port_point.h"

#include <cmath>

#include "known_curve.h"

namespace exsect::port_point_test {
namespace {

using filter::Biquadratic;
using testing::KnownCurve;
using testing::Terms;

}  // namespace

TEST_CASE("port point: a point of a parabola, for either axis, and none away from it", "[filter]") {
  const KnownCurve curve(testing::kParabola);  // v = 1/4 + (u - 1/3)^2
  const double u = 0.7, v = 0.25 + (u - 1.0 / 3) * (u - 1.0 / 3);
  const auto centred = [](double w) { return w - 0.5; };
  const auto on_plane = [](double w) { return (w + 0.25) / 1.5 - 0.5; };
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    const auto ball = filter::point_of_curve<Biquadratic>(
        curve.pair, {centred(u), centred(v) + 1e-4, on_plane(u), on_plane(v)}, axis);
    REQUIRE(ball);
    const double at_u = ball->middle[0] + 0.5, at_v = ball->middle[1] + 0.5;
    CHECK(std::fabs(0.25 + (at_u - 1.0 / 3) * (at_u - 1.0 / 3) - at_v) <= 3 * ball->radius + 1e-15);
    CHECK(filter::has_room<Biquadratic>(*ball));
    const double error = filter::vertex_error<Biquadratic>(
        curve.pair, {ball->middle[0], ball->middle[1], ball->middle[2], ball->middle[3]}, ball->radius);
    CHECK(error >= ball->radius);
    CHECK(error < 1e-6);
  }
  // Where the curve turns, u does not move: its columns are dependent.
  CHECK_FALSE(filter::point_of_curve<Biquadratic>(
      curve.pair, {centred(1.0 / 3), centred(0.25), on_plane(1.0 / 3), on_plane(0.25)}, 1));
}

TEST_CASE("port point: a ball that is too wide has no room", "[filter]") {
  filter::BallOf<Biquadratic> ball{};
  ball.radius = 1e-3;
  CHECK_FALSE(filter::has_room<Biquadratic>(ball));
  ball.radius = NAN;
  CHECK_FALSE(filter::has_room<Biquadratic>(ball));
}

}  // namespace exsect::port_point_test
