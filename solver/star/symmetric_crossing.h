// Where a curve of solutions that a symmetry fixes is crossed by one that it reverses. Internal to solver/;
// docs/method.md, section 6.4.
#pragma once

#include <exsect/algebra/real_algebraic.h>

#include <optional>
#include <vector>

#include "shape/exchanging_symmetry.h"
#include "star/star_neighbourhood.h"

namespace exsect {

/// The fixed solutions in the squares over an irrational double root of the turning eliminant of u or v.
std::vector<CertifiedPoint> fixed_points_over(const ExchangingSymmetry& symmetry, Parameter sweep,
                                              const RealAlgebraic& value);

/// The star of four arcs around such a point, `problem` with the turning values of all four parameters. Empty
/// if it cannot be proved, or if the point is no crossing.
std::optional<StarNeighbourhood> symmetric_crossing_star(const StarQuery& problem,
                                                         const ExchangingSymmetry& symmetry,
                                                         const CertifiedPoint& centre);

}  // namespace exsect
