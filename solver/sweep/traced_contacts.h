// Curves along which the patches touch, traced from fibres and parameter lines. Internal to solver/;
// docs/method.md, section 6.6.
#pragma once

#include "sweep/traced_curves.h"

namespace exsect {

/// Appends to `traced` the curves through the multiple points of the fibres, and the parameter lines along
/// which the patches touch, with their turning points, and as a problem what could not be traced. To be asked
/// for an exact sweep with turning values.
template <class Ball>
void trace_contacts(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks, const SweepData& sweep,
                    const Rational& width, const StopRequest& stop, TracedCurves<Ball>& traced);

}  // namespace exsect
