// The tangent field at the ends of traces. Internal to solver/; docs/method.md, section 5.
#pragma once

#include <functional>

#include "trace/turning_points.h"

namespace exsect {

/// The signs of T at a point, as far as they are certain. `zero`, unless empty, is asked if some are not: the
/// components that are known to vanish.
template <class Ball>
TangentSigns tangent_signs(const PairSystem<Ball>& system, const BallPoint<Ball>& at,
                           const std::function<std::array<bool, 4>()>& zero = {});

/// The sign of the second derivative of parameter j along the curve at a point where T_j = 0; 0: unknown.
template <class Ball>
int bend_sign(const PairSystem<Ball>& system, const BallPoint<Ball>& at, std::size_t j);

/// The direction of T in which the curve would be left again at the end of a trace: +1 or -1.
template <class Ball>
int arriving_direction(const Trace<Ball>& trace);

}  // namespace exsect
