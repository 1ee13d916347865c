// Which of the curves of a lifted curve are lines and conics. Internal to solver/; docs/method-equations.md,
// section 17.7.
#pragma once

#include <vector>

#include "lift/lifted_curve.h"
#include "lift/surface_intersection.h"

namespace exsect {

/// Ids are positions; the arcs are those of the lifted curve, each in one curve; is_closed is not set.
std::vector<SpaceCurve> named_curves(const LiftedCurve& curve);

}  // namespace exsect
