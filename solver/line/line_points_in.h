// The points of a parameter line in a box. Internal to solver/.
#pragma once

#include <exsect/solver/line_query.h>

#include <optional>
#include <vector>

namespace exsect {

/// The point with a box so narrow that it lies in the closed region or does not meet it; empty if that is not
/// reached at the width 2^-2000.
std::optional<CertifiedPoint> decided(CertifiedPoint point, const ParameterBox& region);
/// False: it does not, or that is not known.
bool surely_lies_in(const CertifiedPoint& point, const ParameterBox& region);

/// A box of the point, number `own` of `points` or none of them, that meets no box of another one at the same
/// width, unless that would be less than 2^-2000.
ParameterBox box_apart(CertifiedPoint point, std::size_t own, const std::vector<CertifiedPoint>& points);

/// The points of a parameter line in a closed box; empty if there may be infinitely many, or if that cannot
/// be decided.
std::optional<std::vector<CertifiedPoint>> line_points_in(const BezierPatch& x, const BezierPatch& y,
                                                          const LineQuery& query, const ParameterBox& region);

}  // namespace exsect
