#include "trace/turning_points.h"

#include <cmath>
#include <random>

#include "support/known_curves.h"

namespace exsect::turning_points_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

constexpr std::array<std::size_t, 4> kOneParameter = {2, 3, 0, 1};

TurningPoints<DoubleBall> turning_of(const PairSystem<DoubleBall>& system, Trace<DoubleBall>& trace,
                                     const KnownTangent& known = {}) {
  auto outcome = find_turning_points(system, trace, kOneParameter, known);
  REQUIRE(std::holds_alternative<TurningPoints<DoubleBall>>(outcome));
  return std::get<TurningPoints<DoubleBall>>(std::move(outcome));
}

}  // namespace

TEST_CASE("turning points: the four of a circle, each with both patches' parameters", "[turning]") {
  Trace<DoubleBall> trace = circle_trace();
  const auto points = turning_of(system_of<DoubleBall>(kCircle), trace);
  REQUIRE(points.size() == 4);
  for (const auto& point : points) {
    const std::size_t fixed = turns_in(point, 0) ? 0 : 1;
    CHECK(point.parameters == std::vector<std::size_t>{fixed, fixed + 2});
    CHECK(encloses(point.box[1 - fixed], q(1, 2)));
    CHECK((encloses(point.box[fixed], q(1, 6)) || encloses(point.box[fixed], q(5, 6))));
    CHECK(point.box[0].radius() < 1e-10);
  }
}

TEST_CASE("turning points: the vertex of a parabola, none at its ends", "[turning]") {
  const auto system = system_of<DoubleBall>(kParabola);
  const Landmarks<DoubleBall> landmarks = {on_diagonal(0, q(13, 36)), on_diagonal(1, q(25, 36))};
  auto trace = require_trace(trace_arc(system, landmarks, 0, 1, {}));
  const auto points = turning_of(system, trace);
  REQUIRE(points.size() == 1);
  CHECK(points[0].parameters == std::vector<std::size_t>{1, 3});
  CHECK(encloses(points[0].box[0], q(1, 3)));
  CHECK(encloses(points[0].box[1], q(1, 4)));
}

TEST_CASE("turning points: a vertex on the trace's end is told by the tangent there alone", "[turning]") {
  // v = 1/4 + u^2 begins in its vertex: T_v has no sign in balls about it.
  const HeightCoefficients h = {{{q(-1, 4), 1, 0}, {0, 0, 0}, {-1, 0, 0}}};
  const auto system = system_of<DoubleBall>(h);
  const Landmarks<DoubleBall> landmarks = {on_diagonal(0, q(1, 4)), on_diagonal(q(3, 4), q(13, 16))};
  auto trace = require_trace(trace_arc(system, landmarks, 0, 1, {}));
  auto again = trace;
  CHECK(std::holds_alternative<TraceFailure>(find_turning_points(system, again, kOneParameter)));
  KnownTangent known;
  known.at_start = {1, 0, 1, 0};
  CHECK(turning_of(system, trace, known).empty());
}

TEST_CASE("turning points: those of random ellipses, by their formula", "[turning]") {
  const unsigned seed = 90210;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> any(-6, 6), positive(10, 20);
  for (int round = 0; round < 40; ++round) {
    // a p^2 + 2 b p w + c w^2 = 1 for p = u - 1/2, w = v - 1/2: p is largest, sqrt(c / D), D = a c - b^2,
    // where b p + c w = 0.
    const int a = positive(generator), b = any(generator), c = positive(generator);
    const Rational h = q(1, 2);
    const HeightCoefficients ellipse = {{{(a + 2 * b + c) * h * h - 1, -(b + c) * Rational(1), c},
                                         {-(a + b) * Rational(1), 2 * b, 0},
                                         {a, 0, 0}}};
    const double det = a * c - b * b, most = std::sqrt(c / det);
    const auto system = system_of<DoubleBall>(ellipse);
    const double start = 0.5 + 1 / std::sqrt(a);
    const DoubleBall u = DoubleBall(start).widened(1e-12), v = DoubleBall(0.5).widened(1e-12);
    auto trace = require_trace(trace_loop(system, {}, {u, v, u, v}, {}));
    CAPTURE(a, b, c);
    const auto points = turning_of(system, trace);
    CHECK(points.size() == 4);
    int in_u = 0;
    for (const auto& point : points) {
      const double p = point.box[0].approximation() - 0.5, w = point.box[1].approximation() - 0.5;
      if (turns_in(point, 0)) {
        ++in_u;
        CHECK(std::fabs(p) == Approx(most).epsilon(1e-9));
        CHECK(b * p + c * w == Approx(0).margin(1e-9));
      } else {
        CHECK(a * p + b * w == Approx(0).margin(1e-9));
      }
    }
    CHECK(in_u == 2);
    for (std::size_t j = 0; j < 4; ++j) CHECK_FALSE(may_be_constant(trace, j));
  }
}

TEST_CASE("turning points: a constant parameter does not turn where that is known", "[turning]") {
  // u = 1/3 over the whole square.
  const HeightCoefficients h = {{{q(-1, 3), 0, 0}, {1, 0, 0}, {0, 0, 0}}};
  const auto system = system_of<DoubleBall>(h);
  const Landmarks<DoubleBall> landmarks = {on_diagonal(q(1, 3), 0), on_diagonal(q(1, 3), 1)};
  const int sign = Expansion<DoubleBall>(system, landmarks[0]).tangent()[1].certain_sign();
  REQUIRE(sign != 0);
  auto trace = require_trace(trace_arc(system, landmarks, 0, sign, {}));
  CHECK(may_be_constant(trace, 0));
  CHECK_FALSE(may_be_constant(trace, 1));
  KnownTangent known;
  known.constant = {true, false, true, false};
  CHECK(turning_of(system, trace, known).empty());
}

}  // namespace exsect::turning_points_test
