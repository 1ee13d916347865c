// Enclosures of the arc of a tangential tube. Internal to solver/.
#pragma once

#include "trace/tangential_tube.h"

namespace exsect {

template <class Ball>
ArcEnclosure<Ball> enclosure_between(const PairSystem<Ball>& system, const TangentialTube<Ball>& tube,
                                     double from, double to);

/// A bound of |X''| over all of the arc between two offsets, X the point of space as function of tau;
/// infinite if none is found.
template <class Ball>
double second_derivative_bound(const PairSystem<Ball>& system, const TangentialTube<Ball>& tube, double from,
                               double to);

}  // namespace exsect
