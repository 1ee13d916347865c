// A parameter line of a patch of any kind as a rational curve, beside the patch it meets. Internal to
// solver/.
#pragma once

#include <exsect/geometry/parameter_line.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/line_query.h>

#include <vector>

#include "line/moving_planes.h"

namespace exsect {

/// The line without common factor of its four components, and the other patch, reduced().
struct RationalLine {
  HomogeneousCurve curve;
  RationalPatch patch;
};

/// Throws std::invalid_argument for a value outside [0,1].
RationalLine rational_line(const RationalPatch& x, const RationalPatch& y, const LineQuery& query);

LineShape shape(const HomogeneousCurve& curve);

/// Zero exactly where the vectors C and C' are proportional; zero for a point.
Polynomial standstill_polynomial(const HomogeneousCurve& curve);
/// Where the point of the curve stands still, t in [0,1], ascending: its cusps, and the turns of a straight
/// line that is run through more than once.
std::vector<RealAlgebraic> standstills(const HomogeneousCurve& curve);

}  // namespace exsect
