// Boxes of the parameters whose solutions are known already. Internal to solver/; docs/method-doubles.md,
// section 14.23.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "answer/parameter_box.h"
#include "filter/part.h"

namespace exsect::filter {

/// A box of the parameters, not centred, whose solutions are known: whole closed curves and isolated points
/// of the intersection inside of it (14.95).
struct KnownBox {
  std::array<Part::Interval, 4> range;
};
/// Requires that the ends are doubles.
KnownBox known_box(const ParameterBox& box);

/// Both parts are in it, exactly.
bool lie_in(const KnownBox& box, const Part& x, const Part& y);

/// Whether a curve through a point, which is within `radius` of `middle` (centred) in each parameter, is one
/// of the box; empty if the point may be on the box's boundary.
std::optional<bool> is_in(const KnownBox& box, std::span<const double, 4> middle, double radius);

}  // namespace exsect::filter
