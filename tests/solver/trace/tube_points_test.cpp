#include "trace/tube_points.h"

#include <cmath>
#include <random>

#include "support/known_curves.h"
#include "trace/tube.h"

namespace exsect::tube_points_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

/// Around (u, 1/(4u)) along u.
template <class Ball>
Tube<Ball> hyperbola_tube(const Rational& u, double reach, double least_halfwidth = 0) {
  const auto tube =
      certify_tube(system_of<Ball>(kHyperbola), on_diagonal<Ball>(u, 1 / (4 * u)), 0, reach, least_halfwidth);
  REQUIRE(tube);
  return *tube;
}

template <class Ball>
void check_points(unsigned seed, double radius) {
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> place(30, 90), part(-64, 64);
  for (int round = 0; round < 50; ++round) {
    const Rational u(place(generator), 100);
    const Tube<Ball> tube = hyperbola_tube<Ball>(u, 0x1p-6);
    const double tau = 0x1p-6 * part(generator) / 64;
    const Rational at = tube.centre[0].interval().midpoint() + from_double(tau), v = 1 / (4 * at);
    const BallPoint<Ball> p = point_at(tube, tau);
    CHECK(encloses(p[0], at));
    CHECK(encloses(p[1], v));
    CHECK(encloses(p[2], at));
    CHECK(encloses(p[3], v));
    CHECK(p[1].radius() < radius);
    CHECK(encloses(offset(tube, p), from_double(tau)));
    CHECK(encloses(space_point(tube, p), Point{at, v, 0}));
    // Work ends early where less is enough.
    CHECK(encloses(point_at(tube, tau, 1e-6)[1], v));
  }
}

}  // namespace

TEST_CASE("tube points: on the hyperbola, by its formula", "[tube]") {
  check_points<DoubleBall>(1, 1e-14);
  check_points<DoubleDoubleBall>(2, 1e-28);
  check_points<ArbBall<256>>(3, 1e-60);
}

TEST_CASE("tube points: what a tube contains is on it, and what it excludes is not", "[tube]") {
  const unsigned seed = 4;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  const Tube<DoubleBall> tube = hyperbola_tube<DoubleBall>(q(1, 2), 0x1p-5, 0x1p-8);
  int contained = 0, excluded = 0;
  for (int round = 0; round < 2000; ++round) {
    const double tau = 0x1p-4 * any(generator), size = std::exp2(-20 + 18 * any(generator));
    const double u = 0.5 + tau, v = 1 / (4 * u) + (round % 2 == 0 ? 0 : size * any(generator));
    const double radius = std::exp2(-25 + 20 * any(generator));
    BallPoint<DoubleBall> box = {u, v, u, v};
    for (DoubleBall& c : box) c = c.widened(radius);
    const double off = std::fabs(v - 1 / (4 * u));
    if (contains(tube, box)) {
      ++contained;
      CHECK(std::fabs(tau) + radius <= tube.reach * (1 + 1e-12));
      if (off < radius / 8) CHECK_FALSE(excludes(tube, box));  // it holds a point of the arc
    }
    if (excludes(tube, box)) {
      ++excluded;
      // The box's middle is off the arc: off the curve, or beyond the reach.
      CHECK((off > 0.2 * radius || std::fabs(tau) > tube.reach));
    }
  }
  CHECK(contained > 100);
  CHECK(excluded > 100);
}

}  // namespace exsect::tube_points_test
