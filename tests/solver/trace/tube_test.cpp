#include "trace/tube.h"

#include <cmath>
#include <random>
#include <utility>

#include "support/known_curves.h"
#include "trace/tube_points.h"

namespace exsect::tube_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves
using testing::encloses;

bool encloses(double centre, double error, double value) {
  return std::fabs(centre - value) <= error + 1e-14;
}

template <class Ball>
void check_hyperbola_tube() {
  const auto system = system_of<Ball>(kHyperbola);
  const auto tube = certify_tube(system, on_diagonal<Ball>(q(1, 2), q(1, 2)), 0, 0.05, 0);
  REQUIRE(tube);
  CHECK(tube->contraction < 1);
  for (const double tau : {-0.05, -0.03, 0.0, 0.001, 0.05}) {
    const BallPoint<Ball> p = point_at(*tube, tau);
    const Rational u = q(1, 2) + from_double(tau);
    const Rational v = 1 / (4 * u);
    CHECK(encloses(p[0], u));
    CHECK(encloses(p[1], v));
    CHECK(encloses(p[3], v));
    CHECK(p[1].radius() < 1e-14);
    CHECK(contains(*tube, point_at(*tube, 0.9 * tau)));
    CHECK_FALSE(excludes(*tube, p));
    CHECK(encloses(space_point(*tube, p)[1], v));
    const double ud = to_double(u);
    CHECK(encloses(tube->slope[1], tube->slope_error[1], -1 / (4 * ud * ud)));
    CHECK(encloses(tube->second[1], tube->second_error[1], 1 / (2 * ud * ud * ud)));
    CHECK(tube->space_second_derivative >= 1 / (2 * ud * ud * ud));
    BallPoint<Ball> beside = p;
    beside[1] = (beside[1] + Ball(1e-6)).midpoint();
    CHECK(excludes(*tube, beside));
  }
  // T = (h_v, -h_u, ...): T_u = u > 0.
  CHECK(tube->orientation == 1);
}

}  // namespace

TEST_CASE("a tube encloses the hyperbola u v = 1/4", "[tube]") {
  check_hyperbola_tube<DoubleBall>();
  check_hyperbola_tube<ArbBall<256>>();
}

TEST_CASE("a tube follows a bent chart of a line beside a second line at the distance 2e-20", "[tube]") {
  // (u - v/3 - 1/4)² = e² in the plane ((r + r²)/2, (3s - s²)/2, 0), over s: v = (3s - s²)/2.
  const Rational e = Rational(1) / pow(Integer(10), 20);
  const HeightCoefficients lines = {
      {{q(1, 16) - e * e, q(1, 6), q(1, 9)}, {q(-1, 2), q(-2, 3), 0}, {1, 0, 0}}};
  ControlNet chart{};
  chart[1][0][0] = chart[2][0][0] = q(1, 2);
  chart[0][1][1] = q(3, 2);
  chart[0][2][1] = q(-1, 2);
  using Ball = ArbBall<256>;
  const PairSystem<Ball> system(graph_patch(lines), BezierPatch::from_power_basis(chart), Point{0, 0, 0}, 0);
  const auto on_curve = [&](const Rational& s, int side) {
    const Rational v = s * (3 - s) / 2;
    const Rational u = v / 3 + q(1, 4) + side * e;
    const double r = (std::sqrt(1 + 8 * to_double(u)) - 1) / 2;
    const auto point = newton_corrected(
        system, BallPoint<Ball>{Ball::enclosing(u), Ball::enclosing(v), Ball(r), Ball::enclosing(s)}, 3, 4);
    REQUIRE(point);
    return *point;
  };
  const auto tube = certify_tube(system, on_curve(q(1, 2), 1), 3, 0.03, 0);
  REQUIRE(tube);
  for (const double tau : {-0.03, -0.01, 0.0, 0.02, 0.03}) {
    const Rational s = q(1, 2) + from_double(tau);
    const Rational v = s * (3 - s) / 2;
    const BallPoint<Ball> p = point_at(*tube, tau);
    CHECK(encloses(p[1], v));
    CHECK(encloses(p[0], v / 3 + q(1, 4) + e));
    CHECK(p[0].radius() < 1e-30);
    CHECK(encloses(tube->slope[1], tube->slope_error[1], 1.5 - to_double(s)));
    CHECK(encloses(tube->second[1], tube->second_error[1], -1));
    CHECK_FALSE(excludes(*tube, p));
    BallPoint<Ball> other = on_curve(s, -1);
    CHECK(encloses(other[0].widened(1e-40), v / 3 + q(1, 4) - e));
    CHECK(excludes(*tube, other));
  }
}

TEST_CASE("no tube is certified around a crossing, nor where it is too long", "[tube]") {
  const auto crossing = system_of<DoubleBall>(kCrossing);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    for (const double reach : {1e-1, 1e-3, 1e-6, 1e-9}) {
      CHECK_FALSE(certify_tube(crossing, on_diagonal(q(1, 2), q(1, 2)), axis, reach, 0));
      CHECK_FALSE(
          certify_tube(crossing, on_diagonal(q(1, 2) + q(1, 1000000000), q(1, 2)), axis, reach, 2e-9));
    }
  }
  const auto circle = system_of<DoubleBall>(kCircle);
  CHECK_FALSE(certify_tube(circle, on_diagonal(q(1, 2), q(5, 6)), 0, 0.4, 0));
}

template <class Ball>
void check_derivatives_between() {
  const auto system = system_of<Ball>(kHyperbola);
  const auto tube = certify_tube(system, on_diagonal<Ball>(q(1, 2), q(1, 2)), 0, 0.05, 0);
  REQUIRE(tube);
  for (const auto& [from, to] : {std::pair(-0.05, 0.05), {0.02, -0.01}, {0.03, 0.0301}, {0.05, 0.05}}) {
    const ValueRange slope = slope_between(*tube, 1, from, to);
    const ValueRange second = second_between(*tube, 1, from, to);
    for (const double part : {0.0, 0.3, 1.0}) {
      const double u = 0.5 + from + part * (to - from);
      CHECK(std::fabs(-1 / (4 * u * u) - slope.middle) <= slope.error + 1e-14);
      CHECK(std::fabs(1 / (2 * u * u * u) - second.middle) <= second.error + 1e-13);
    }
    // v' changes by at most max v'' |to - from|; the remainder is of order reach^3.
    CHECK(slope.error < 5.5 * std::fabs(to - from) / 2 + 6e-3);
    CHECK(slope_between(*tube, 0, from, to).middle == 1);
  }
  CHECK(slope_between(*tube, 1, 0.03, 0.0301).error < 0.2 * slope_between(*tube, 1, -0.05, 0.05).error);
}

TEST_CASE("derivatives along a part of a tube", "[tube]") {
  check_derivatives_between<DoubleBall>();
  check_derivatives_between<DoubleDoubleBall>();
  check_derivatives_between<ArbBall<256>>();
}

TEST_CASE("derivatives along random parts of tubes", "[tube]") {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto system = system_of<DoubleBall>(kCircle);  // v = 1/2 + sqrt(1/9 - (u - 1/2)²)
  for (int round = 0; round < 200; ++round) {
    const double u = 0.5 + 0.2 * any(generator);
    const double v = 0.5 + std::sqrt(1.0 / 9 - (u - 0.5) * (u - 0.5));
    const auto tube = certify_tube(system, BallPoint<DoubleBall>{u, v, u, v}, 0, 0.02, 0);
    REQUIRE(tube);
    const double from = 0.02 * any(generator), to = 0.02 * any(generator);
    const ValueRange slope = slope_between(*tube, 3, from, to);
    const ValueRange second = second_between(*tube, 3, from, to);
    for (const double part : {0.0, 0.5, 1.0}) {
      const double a = u + from + part * (to - from) - 0.5;
      const double height = std::sqrt(1.0 / 9 - a * a);
      CHECK(std::fabs(-a / height - slope.middle) <= slope.error + 1e-12);
      CHECK(std::fabs(-1 / (9 * height * height * height) - second.middle) <= second.error + 1e-11);
    }
  }
}

TEST_CASE("the largest reach is one that is proved, and longer ones are not", "[tube]") {
  for (const Rational& e : {q(1, 1000), q(1, 1000000)}) {  // u v = e + ..., the branches e apart
    const HeightCoefficients h = {{{q(1, 4) - e, q(-1, 2), 0}, {q(-1, 2), 1, 0}, {0, 0, 0}}};
    const auto system = system_of<DoubleBall>(h);
    const double offset = std::sqrt(to_double(e));
    const auto vertex = newton_corrected(
        system, BallPoint<DoubleBall>{0.5 + offset, 0.5 + offset, 0.5 + offset, 0.5 + offset}, 0, 4);
    REQUIRE(vertex);
    const double reach = largest_reach(system, *vertex, 0, 1e-12, 0.25, 0, 0.5);
    REQUIRE(reach > 0);
    const auto tube = certify_tube(system, *vertex, 0, reach, 0);
    REQUIRE(tube);
    CHECK(tube->contraction <= 0.5);
    const auto longer = certify_tube(system, *vertex, 0, 2 * reach, 0);
    CHECK((!longer || longer->contraction > 0.5));
    CHECK(reach < offset);
    CHECK(reach > offset / 32);
  }
  const auto crossing = system_of<DoubleBall>(kCrossing);
  CHECK(largest_reach(crossing, on_diagonal(q(1, 2), q(1, 2)), 0, 1e-12, 0.1, 0, 0.5) == 0);
}

}  // namespace exsect::tube_test
