// The pieces of a self-intersection next to cuspidal points. Internal to solver/; docs/method.md,
// section 7.2.
#pragma once

#include "self/places.h"

namespace exsect {

/// Appends the cuspidal points outside of the places, the traces that start in them, and their gates as
/// landmarks, or what is in the way.
template <class Ball>
void add_near_cusps(SelfCurves<Ball>& found, const SelfSystem<Ball>& system, const ExactPlaces& exact,
                    const KnownPlaces& places, const Rational& width, const StopRequest& stop);

/// True only if the point of the chart, known to be on the curve, is on one of these traces or next to their
/// cuspidal points.
template <class Ball>
bool passes_near_cusp(const SelfCurves<Ball>& curves, Chart chart, const BallPoint<Ball>& point);

}  // namespace exsect
