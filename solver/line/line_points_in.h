// The points of a parameter line in a box. Internal to solver/.
#pragma once

#include <exsect/solver/line_query.h>

#include <optional>
#include <vector>

namespace exsect {

/// The points of a parameter line in a closed box; empty if there may be infinitely many, or if that cannot
/// be decided.
std::optional<std::vector<CertifiedPoint>> line_points_in(const BezierPatch& x, const BezierPatch& y,
                                                          const LineQuery& query, const ParameterBox& region);

}  // namespace exsect
