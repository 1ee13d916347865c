// Exact pairs x(u1,v1) = x(u2,v2) over one value of a parameter. Internal to solver/; docs/method.md, 7.1.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>
#include <exsect/solver/line_query.h>

#include <optional>
#include <vector>

namespace exsect {

/// All pairs of different points with the given value of one parameter, as points (u,v,r,s) = (u1,v1,u2,v2)
/// in a closed box; empty if there are infinitely many over the value, inside the box or not, but for points
/// of a side that is one point and outside of the box, or if that cannot be decided.
std::optional<std::vector<CertifiedPoint>> pairs_in(const BezierPatch& x, const LineQuery& query,
                                                    const ParameterBox& region);

/// Whether a line u = constant (fixed: 0) or v = constant (1) with its constant in the closed range turns
/// inside the square and the closed range `along`, or all these lines are straight.
bool has_folded_line(const BezierPatch& x, std::size_t fixed, const RationalInterval& range,
                     const RationalInterval& along);

}  // namespace exsect
