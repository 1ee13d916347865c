// Balls against rational numbers, and pairs of patches in balls.
#pragma once

#include <exsect/algebra/ball.h>

#include "support/random_pairs.h"
#include "trace/pair_system.h"

namespace exsect::testing {

template <class Ball>
bool encloses(const Ball& ball, const Rational& value) {
  const RationalInterval at = ball.interval();
  return at.lower <= value && value <= at.upper;
}

template <class Ball>
bool encloses(const BallVector<Ball>& ball, const Point& value) {
  return encloses(ball[0], value[0]) && encloses(ball[1], value[1]) && encloses(ball[2], value[2]);
}

template <class Ball>
BallPoint<Ball> ball_point(const std::array<Rational, 4>& w) {
  return {Ball::enclosing(w[0]), Ball::enclosing(w[1]), Ball::enclosing(w[2]), Ball::enclosing(w[3])};
}

/// Multiples of 1/64 in the square.
inline std::array<Rational, 4> random_place(random_pairs::Generator& generator) {
  std::array<Rational, 4> w;
  for (Rational& q : w) q = Rational(random_pairs::integer(generator, 0, 64), 64);
  return w;
}

}  // namespace exsect::testing
