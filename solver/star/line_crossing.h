// Where a parameter line with an irrational value lies on the other patch and other arcs of the intersection
// meet it. Internal to solver/; docs/method.md, section 6.4.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <optional>
#include <vector>

#include "star/star_neighbourhood.h"

namespace exsect {

/// A point with irrational values α of the sweep parameter and β of the other one of the same patch. Next to
/// it a point with the value α over a rational value near β is known, exactly.
struct LineCrossing {
  RealAlgebraic value;
  RealAlgebraic along;
  ParameterBox near;  // around both
};

/// Candidates over a turning value α = `value`: β from the turning values `along`.
std::vector<LineCrossing> line_crossings(const BezierPatch& x, const BezierPatch& y, Parameter sweep,
                                         const RealAlgebraic& value, const TurningValues& along);

/// The star of three arcs or more around the point, two of them on the line: `problem` with the turning
/// values of all four parameters. Empty if it cannot be proved.
std::optional<StarNeighbourhood> line_crossing_star(const StarQuery& problem, const LineCrossing& crossing);

}  // namespace exsect
