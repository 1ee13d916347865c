// Limits of the options of intersections. Internal to solver/.
#pragma once

#include <exsect/solver/intersect.h>

namespace exsect {

/// Polylines finer than this are not made; one that is asked for is incomplete, and as fine as the coarse
/// tolerance.
inline constexpr double kFinestTolerance = 1e-12;
inline constexpr double kCoarseTolerance = 1e-9;

/// Throws std::invalid_argument for a tolerance or time that is not positive, or a tolerance that is
/// infinite.
void check(const IntersectOptions& options);

}  // namespace exsect
