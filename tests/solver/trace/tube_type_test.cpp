#include "trace/tube_type.h"

#include <cmath>
#include <random>

#include "support/known_curves.h"
#include "trace/tube.h"
#include "trace/tube_evaluation.h"

namespace exsect::tube_type_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

/// |w_j - p_j - l_j(tau)|
template <class Ball>
double off_line(const Tube<Ball>& tube, std::size_t j, double tau, double w) {
  const Ball there = tube.centre[j] + tubes::on_line(tube, j, Ball(tau / tube.scale));
  return std::fabs(w - there.approximation());
}

}  // namespace

TEST_CASE("tube type: over every offset the tube holds the curve's point, and no other one", "[tube]") {
  const unsigned seed = 20304;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> part(-1, 1);
  // Where v is 1/2 + h there are two points of the circle, over u = 1/2 +- sqrt(1/9 - h^2).
  for (const auto& piece : circle_trace().pieces) {
    const Tube<DoubleBall>& tube = piece.tube;
    CHECK(tube.contraction < 1);
    CHECK(tube.reach <= tube.scale);
    CHECK(tube.halfwidth[tube.axis] == 0);
    CHECK(tube.slope[tube.axis] == 1);
    const std::size_t along = tube.axis % 2, across = 1 - along;
    for (int i = 0; i < 20; ++i) {
      const double tau = tube.reach * part(generator);
      const double h = tube.centre[along].approximation() + tau - 0.5;
      const double root = std::sqrt(1.0 / 9 - h * h);
      int inside = 0;
      for (const double w : {0.5 + root, 0.5 - root}) {
        const bool near = off_line(tube, across, tau, w) <= tube.halfwidth[across] &&
                          off_line(tube, across + 2, tau, w) <= tube.halfwidth[across + 2];
        if (near) ++inside;
      }
      CHECK(inside == 1);
    }
  }
}

TEST_CASE("tube type: the orientation is that of the tangent field", "[tube]") {
  for (const auto& piece : circle_trace().pieces) {
    const Tube<DoubleBall>& tube = piece.tube;
    const auto tangent = Expansion<DoubleBall>(system_of<DoubleBall>(kCircle), tube.centre).tangent();
    CHECK(tangent[tube.axis].certain_sign() == tube.orientation);
  }
}

}  // namespace exsect::tube_type_test
