// Which multiple turning values may lie under singular points that are not known. Internal to solver/.
#pragma once

#include <vector>

#include "sweep/traced_curves.h"

namespace exsect {

/// Over a root of E of multiplicity m there is no further singular point if the regular turning points over
/// it, and twice the singular ones that are known, make up m: so much of m is taken up by each
/// (docs/method.md, Theorem 4.4); nor over a rational root if all multiple points of its fibre are on traced
/// curves or in stars. Returns the other turning values of sweep.turning that are not simple roots.
template <class Ball>
std::vector<const TurningValue*> undecided_turning_values(const SweepData& sweep,
                                                          const TracedCurves<Ball>& traced,
                                                          const Rational& width);

}  // namespace exsect
