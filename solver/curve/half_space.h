// Vectors on one side of a plane through the origin. Internal to solver/.
#pragma once

#include <exsect/geometry/point.h>

#include <array>
#include <optional>
#include <vector>

namespace exsect {

/// A guess of n with n.w > 0 for all of the vectors but those that are about zero.
std::optional<Point> positive_direction(std::vector<std::array<double, 3>> vectors);

/// n.w > 0 for all of the vectors but those that are zero, and there are others.
bool all_positive(const Point& n, const std::vector<Point>& vectors);

/// True only if n.w > 0 for all of the vectors, with some n.
bool lie_in_half_space(const std::vector<Point>& vectors);

}  // namespace exsect
