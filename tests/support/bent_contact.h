// Two patches that touch along a curve on which one parameter turns, by closed formulas.
#pragma once

#include "eliminant/exact_pair.h"
#include "support/known_curves.h"
#include "trace/tangential_arc.h"

namespace exsect::testing {

/// (u, v, (v - u)^2) touches (r + 2 (s - 1/2)^2, s, 0) along u = v = s, r = u - 2 (u - 1/2)^2, from r = 0 at
/// u = (3 - sqrt(5)) / 4 to u = 1, r = 1/2; r turns in u = 3/4.
struct BentContact {
  BezierPatch x = graph({{{0, 2}, 1}, {{1, 1}, -2}, {{2, 0}, 1}});
  BezierPatch y = bent_plane();
  ExactPair pair{x, y};
  PairSystem<DoubleBall> system{x, y, Point{0, 0, 0}, 0};
  Landmarks<DoubleBall> ends = {ball_point<DoubleBall>(at(1)), first_end()};

  static BezierPatch bent_plane() {
    ControlNet c{};
    c[0][0] = {q(1, 2), 0, 0};
    c[1][0] = {1, 0, 0};
    c[0][1] = {-2, 1, 0};
    c[0][2] = {2, 0, 0};
    return BezierPatch::from_power_basis(c);
  }
  static std::array<Rational, 4> at(const Rational& u) {
    return {u, u, u - 2 * (u - q(1, 2)) * (u - q(1, 2)), u};
  }
  static BallPoint<DoubleBall> first_end() {
    const DoubleBall u = DoubleBall(0.25 * (3 - std::sqrt(5.0))).widened(1e-15);
    return {u, u, 0, u};
  }

  TangentialArc<DoubleBall> traced() const {
    auto outcome = trace_contact(system, ends, ball_point<DoubleBall>(at(q(1, 2))), {});
    REQUIRE(std::holds_alternative<TangentialArc<DoubleBall>>(outcome));
    return std::get<TangentialArc<DoubleBall>>(std::move(outcome));
  }
};

}  // namespace exsect::testing
