// Which of the curves of two equations are lines and conics. Internal to solver/; docs/method-equations.md,
// section 17.15.
#pragma once

#include <vector>

#include "lift/crossing_curve.h"

namespace exsect {

/// As for lifted curves (curve_names.h): lines and conics that are defined over Q or are one of two that are
/// conjugate over a quadratic field are named; others are connected parts.
std::vector<SpaceCurve> named_curves(const CrossingCurve& curve);

}  // namespace exsect
