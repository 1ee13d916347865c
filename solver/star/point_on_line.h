// Points at an algebraic parameter of a line that lies on the other patch. Internal to solver/.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>
#include <exsect/solver/line_query.h>

#include <vector>

namespace exsect {

/// The points over the value `along` of the parameter along `line`, which lies on the other patch in an
/// interval around it; those at which the other patch is regular, as far as they can be enclosed.
/// Multiplicity and branch are 0.
std::vector<CertifiedPoint> points_on_line(const BezierPatch& x, const BezierPatch& y, const LineQuery& line,
                                           const RealAlgebraic& along);

}  // namespace exsect
