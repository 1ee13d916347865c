// Points of a line as solutions of its triangular system. Internal to solver/.
#pragma once

#include "line/line_point.h"

namespace exsect {

/// The points at a solution (r,s) of the system in [0,1]^2, in the order of pieces_at: one for every t in
/// [0,1] with phi(t) = lambda there. `eliminant` serves the multiplicity; zero: the multiplicity of the point
/// is not defined (0). `width`: of the boxes.
std::vector<CertifiedPoint> system_points(const LinePlace& place,
                                          const std::shared_ptr<const LineSystem>& system,
                                          const TriangularPoint& at, const Polynomial& eliminant,
                                          const Rational& width);

}  // namespace exsect
