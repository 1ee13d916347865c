// Points of every closed curve on a round chart. Internal to solver/; docs/method-equations.md, section
// 17.21.
#pragma once

#include <optional>
#include <vector>

#include "filter/round_chart.h"

namespace exsect {

/// Boxes with one zero of f in each that is where its derivative by the angle about the axis is 0 as well, or
/// on one of two opposite circles of a torus about its axis: all of those, but for points on a nappe that
/// does not belong to the other surface. The boxes are apart. Empty if doubles do not decide it.
std::optional<std::vector<RoundBox>> round_landmarks(const RoundChart& chart);

/// Whether both boxes are certainly apart, or the first one certainly in the other one.
bool are_apart(const RoundChart& chart, const RoundBox& a, const RoundBox& b);
bool is_within(const RoundChart& chart, const RoundBox& a, const RoundBox& b);

}  // namespace exsect
