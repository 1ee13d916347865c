// In which directions curves leave boundary points and ports. Internal to solver/.
#pragma once

#include <optional>
#include <vector>

#include "sweep/sweep_data.h"
#include "trace/turning_points.h"

namespace exsect {

/// T at a landmark of sweep.landmarks, enclosed in landmarks; nothing for -1.
template <class Ball>
TangentSigns tangent_signs_at(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                              const SweepData& sweep, int landmark);

/// +1, -1: the directions of the tangent field that enter the domain at this boundary point or port; empty:
/// unknown.
template <class Ball>
std::optional<std::vector<int>> entering_directions(const PairSystem<Ball>& system,
                                                    const Landmarks<Ball>& landmarks, const SweepData& sweep,
                                                    std::size_t landmark);

}  // namespace exsect
