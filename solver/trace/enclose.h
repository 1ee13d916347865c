// Exact points as balls. Internal to solver/.
#pragma once

#include <exsect/solver/certified_point.h>

#include "trace/pair_system.h"

namespace exsect {

/// The point's box, refined to `width` in every parameter, as balls.
template <class Ball>
BallPoint<Ball> enclose(const CertifiedPoint& point, const Rational& width) {
  const ParameterBox box = point.refined_to(width).box();
  return {Ball::enclosing(box[0]), Ball::enclosing(box[1]), Ball::enclosing(box[2]), Ball::enclosing(box[3])};
}

}  // namespace exsect
