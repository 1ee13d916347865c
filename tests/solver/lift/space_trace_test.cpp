// Arcs of a circle and of a twisted cubic from landmark to landmark.
#include "lift/space_trace.h"

#include <cmath>

#include "answer/proof_failure.h"
#include "support/catch.h"

namespace exsect::space_trace_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                      z = SpacePolynomial::variable(2);
SpacePolynomial number(const Rational& c) { return SpacePolynomial::constant(c); }

SpaceZero landmark(const Point& p) { return {p, 0x1p-80}; }

}  // namespace

TEST_CASE("space trace: around a circle, both ways") {
  const Point a = {1, 0, 0}, b = {Rational(-3, 5), Rational(4, 5), 0}, c = {0, -1, 0};
  for (const double tolerance : {1e-2, 1e-6}) {
    const TraceProblem problem{x * x + y * y + z * z - number(1),
                               z,
                               {landmark(a), landmark(b), landmark(c), landmark({0, 0, 1})},
                               2,
                               tolerance};
    // grad F x grad G is clockwise.
    for (const auto& [sense, end] : {std::pair(1, 2), std::pair(-1, 1)}) {
      const SpaceTrace trace = space_trace(problem, 0, sense);
      CHECK(trace.end == static_cast<std::size_t>(end));
      CHECK(trace.error_bound <= 1.01 * tolerance);
      CHECK(trace.points.front() == std::array<double, 3>{1, 0, 0});
      double length = 0;
      for (std::size_t k = 0; k + 1 < trace.points.size(); ++k) {
        const auto &p = trace.points[k], &q = trace.points[k + 1];
        CHECK(std::fabs(std::hypot(p[0], p[1]) - 1) < 1e-14);
        const double sagitta = 1 - std::hypot((p[0] + q[0]) / 2, (p[1] + q[1]) / 2);
        CHECK(sagitta <= trace.error_bound);
        length += std::hypot(p[0] - q[0], p[1] - q[1]);
      }
      CHECK(std::fabs(length - (sense > 0 ? std::acos(0.0) : std::acos(-0.6))) < 4 * tolerance);
    }
    CHECK(space_trace(problem, 1, 1).end == 0);
  }
}

TEST_CASE("space trace: a twisted cubic, and a landmark that is not reached") {
  const auto at = [](const Rational& t) { return landmark({t, t * t, t * t * t}); };
  TraceProblem problem{y - x * x, z - x * y, {at(-1), at(Rational(1, 3)), at(2)}, 8, 1e-3};
  // grad F x grad G = (1, 2x, ...) has x growing.
  CHECK(space_trace(problem, 0, 1).end == 1);
  CHECK(space_trace(problem, 1, 1).end == 2);
  CHECK(space_trace(problem, 2, -1).end == 1);
  // Into a crossing there are no tubes.
  const TraceProblem crossing{x * y, z, {landmark({1, 0, 0}), landmark({-1, 0, 0})}, 2, 1e-3};
  CHECK_THROWS_AS(space_trace(crossing, 0, -1), ProofFailure);
}

}  // namespace exsect::space_trace_test
