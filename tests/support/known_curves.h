// Curves h(u,v) = 0 with closed formulas, as the intersection of a graph and the plane (r, s, 0): r = u, s =
// v.
#pragma once

#include <variant>

#include "support/ball_checks.h"
#include "support/catch.h"
#include "support/graph_patches.h"
#include "trace/tracer.h"

namespace exsect::testing {

inline Rational q(long numerator, long denominator = 1) { return Rational(numerator, denominator); }

/// u v = 1/4 in the plane: v = 1/(4u).
inline const HeightCoefficients kHyperbola = {{{q(-1, 4), 0, 0}, {0, 1, 0}, {0, 0, 0}}};
/// (u-1/2)^2 + (v-1/2)^2 = 1/9.
inline const HeightCoefficients kCircle = {{{q(7, 18), -1, 1}, {-1, 0, 0}, {1, 0, 0}}};
/// (u-1/2)(v-1/2) = 0: a crossing in the middle.
inline const HeightCoefficients kCrossing = {{{q(1, 4), q(-1, 2), 0}, {q(-1, 2), 1, 0}, {0, 0, 0}}};
/// v = 1/4 + (u-1/3)^2.
inline const HeightCoefficients kParabola = {{{q(-13, 36), 1, 0}, {q(2, 3), 0, 0}, {-1, 0, 0}}};

template <class Ball>
PairSystem<Ball> system_of(const HeightCoefficients& h) {
  const Point origin = {0, 0, 0};
  return PairSystem<Ball>(graph_patch(h), plane_patch(), origin, 0);
}

template <class Ball = DoubleBall>
BallPoint<Ball> on_diagonal(const Rational& u, const Rational& v) {
  return ball_point<Ball>({u, v, u, v});
}

inline Trace<DoubleBall> require_trace(std::variant<Trace<DoubleBall>, TraceFailure> outcome) {
  REQUIRE(std::holds_alternative<Trace<DoubleBall>>(outcome));
  return std::get<Trace<DoubleBall>>(std::move(outcome));
}

/// The circle, once around from (1/2 + 1/3 3/5, 1/2 + 1/3 4/5).
inline Trace<DoubleBall> circle_trace() {
  return require_trace(trace_loop(system_of<DoubleBall>(kCircle), {}, on_diagonal(q(7, 10), q(23, 30)), {}));
}

}  // namespace exsect::testing
