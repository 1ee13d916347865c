#include "trace/tube_derivatives.h"

#include <cmath>
#include <random>

#include "support/known_curves.h"
#include "trace/tube.h"

namespace exsect::tube_derivatives_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

/// The largest ratio of what the derivatives miss their middle by and of its bound, over the hyperbola's
/// tubes along u.
template <class Ball>
void check_hyperbola(unsigned seed) {
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0.3, 0.9), part(-1, 1);
  for (int round = 0; round < 100; ++round) {
    const double u = place(generator), reach = std::exp2(-5 - round % 20);
    const Rational at = from_double(u);
    const auto tube =
        certify_tube(system_of<Ball>(kHyperbola), on_diagonal<Ball>(at, 1 / (4 * at)), 0, reach, 0);
    REQUIRE(tube);
    const double tau = reach * part(generator), p = u + tau;
    const double first = -1 / (4 * p * p), second = 1 / (2 * p * p * p);
    const double rounding = 1e-14;
    for (const std::size_t j : {1U, 3U}) {
      CHECK(std::fabs(first - tube->slope[j]) <= tube->slope_error[j] + rounding);
      CHECK(std::fabs(second - tube->second[j]) <= tube->second_error[j] + rounding);
      // The slope changes by v'' tau: the bound is no more than some times that.
      CHECK(tube->slope_error[j] <= 4 / (2 * std::pow(u - reach, 3)) * reach + 1e-9);
    }
    CHECK(std::fabs(tube->slope[2] - 1) <= tube->slope_error[2] + rounding);
    CHECK(tube->slope_error[0] == 0);
    CHECK(tube->space_second_derivative >= second * (1 - 1e-12));
    CHECK(tube->space_second_derivative <= 3 / (2 * std::pow(u - reach, 3)));
  }
}

}  // namespace

TEST_CASE("tube derivatives: of the hyperbola, by its formula", "[tube]") {
  check_hyperbola<DoubleBall>(20301);
  check_hyperbola<DoubleDoubleBall>(20302);
  check_hyperbola<ArbBall<256>>(20303);
}

TEST_CASE("tube derivatives: chords stay within |X''| h^2 / 8 of a circle", "[tube]") {
  for (const auto& piece : circle_trace().pieces) {
    const Tube<DoubleBall>& tube = piece.tube;
    const double u = tube.centre[0].approximation(), v = tube.centre[1].approximation();
    const double dx = u - 0.5, dy = v - 0.5, radius = 1.0 / 3;
    // Over a coordinate, with the other one at a distance d from the circle's middle, |X''| = R^2 / |d|^3.
    const double d = tube.axis % 2 == 0 ? dy : dx;
    const double there = radius * radius / std::pow(std::fabs(d), 3);
    CHECK(tube.space_second_derivative >= there * (1 - 1e-9));
  }
}

TEST_CASE("tube derivatives: column bounds are below the contraction and vanish for the axis", "[tube]") {
  for (const auto& piece : circle_trace().pieces) {
    const Tube<DoubleBall>& tube = piece.tube;
    Row3 sum{};
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t row = 0; row < 3; ++row) {
        if (j == tube.axis) CHECK(tube.deviation[j][row] == 0);
        sum[row] += tube.deviation[j][row];
      }
    for (std::size_t row = 0; row < 3; ++row) CHECK(sum[row] <= tube.contraction * (1 + 1e-12));
  }
}

}  // namespace exsect::tube_derivatives_test
