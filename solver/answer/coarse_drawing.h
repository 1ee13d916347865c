// Whether polylines are as fine as was asked for. Internal to solver/.
#pragma once

#include <exsect/solver/result.h>

#include <optional>

namespace exsect {

/// Empty if all arcs of the graph, those on rims of overlaps too, are proved to keep within the tolerance (a
/// length).
std::optional<CoarseDrawing> coarse_drawing(const IntersectionGraph& graph, double tolerance);

}  // namespace exsect
