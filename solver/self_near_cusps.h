// The pieces of a self-intersection next to cuspidal points. Internal to solver/; docs/method.md,
// section 7.2.
#pragma once

#include "self_curves.h"

namespace exsect {

/// Appends the cuspidal points outside of the places, the traces that start in them, and their gates as
/// landmarks, or what is in the way.
template <class Ball>
void add_near_cusps(SelfCurves<Ball>& found, const SelfSystem<Ball>& system, const ExactPlaces& exact,
                    const KnownPlaces& places, const Rational& width, const StopRequest& stop);

}  // namespace exsect
