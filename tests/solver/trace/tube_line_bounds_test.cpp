#include "trace/tube_line_bounds.h"

#include <cmath>

#include "support/known_curves.h"
#include "trace/tube.h"
#include "trace/tube_evaluation.h"

namespace exsect::tube_line_bounds_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

/// C F on the centre line of a tube, and the bends of the line, against their bounds.
template <class Ball>
void check_along(Tube<Ball> tube, double rounding) {
  const auto left = fit_line(tube);
  REQUIRE(left);
  const AlongLine along = along_line(tube, *left);
  for (int i = -16; i <= 16; ++i) {
    const double tau = tube.reach * i / 16;
    const Ball sigma(tau / tube.scale);
    BallPoint<Ball> on_the_line;
    for (std::size_t j = 0; j < 4; ++j) {
      on_the_line[j] = j == tube.axis ? Ball(tau) : tubes::on_line(tube, j, sigma);
      if (j == tube.axis) continue;
      const Ball linear = sigma * tube.line[0][j];
      const Ball bend = on_the_line[j] - linear, higher = bend - sigma * sigma * tube.line[1][j];
      CHECK(bend.lower_magnitude() <= along.bend[j].value);
      CHECK(higher.lower_magnitude() <= along.higher_bend[j].value);
    }
    const BallVector<Ball> residual =
        tubes::premultiplied_value(tube, tubes::preconditioner_at(tube, sigma), on_the_line);
    for (std::size_t row = 0; row < 3; ++row) {
      CHECK(residual[row].lower_magnitude() <= along.residual[row].value);
      CHECK(residual[row].upper_magnitude() <= 4 * along.residual[row].value + rounding);
    }
  }
}

template <class Ball>
Tube<Ball> parabola_tube(double reach) {
  // v = 1/4 + (u - 1/3)^2 at u = 1/2, where v = 5/18.
  const auto tube =
      certify_tube(system_of<Ball>(kParabola), on_diagonal<Ball>(q(1, 2), q(5, 18)), 0, reach, 0);
  REQUIRE(tube);
  return *tube;
}

}  // namespace

TEST_CASE("tube line bounds: what is evaluated on the line is within them", "[tube]") {
  for (const double reach : {0x1p-3, 0x1p-6, 0x1p-12}) {
    check_along(parabola_tube<DoubleBall>(reach), 1e-14);
    check_along(parabola_tube<DoubleDoubleBall>(reach), 1e-14);
    check_along(parabola_tube<ArbBall<256>>(reach), 1e-14);
  }
  for (const auto& piece : circle_trace().pieces) check_along(piece.tube, 1e-12);
}

TEST_CASE("tube line bounds: a parabola bends by tau^2, and by nothing more", "[tube]") {
  Tube<ArbBall<256>> tube = parabola_tube<ArbBall<256>>(0x1p-4);
  const auto left = fit_line(tube);
  REQUIRE(left);
  const AlongLine along = along_line(tube, *left);
  for (const std::size_t j : {1U, 3U}) {
    CHECK(along.bend[j].value == Approx(0x1p-8));
    CHECK(along.bend[j].first == Approx(2 * 0x1p-4));
    CHECK(along.bend[j].second == Approx(2));
    CHECK(along.higher_bend[j].value < 1e-60);
  }
  CHECK(along.bend[2].value < 1e-60);
  for (const SeriesBound& bound : along.residual) CHECK(bound.value < 1e-60);
}

}  // namespace exsect::tube_line_bounds_test
