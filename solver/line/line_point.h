// Certified points on a parameter line from their exact descriptions.
#pragma once

#include <exsect/algebra/triangular_point.h>
#include <exsect/solver/certified_point.h>

#include <memory>
#include <vector>

#include "line/line_forms.h"
#include "line/line_place.h"
#include "line/line_system.h"

namespace exsect {

/// Width of the boxes of new points.
Rational initial_width();

/// The points over a root s of the eliminant with s1(s) != 0: one, or none if it is outside the square or
/// [0,1].
std::vector<CertifiedPoint> conic_point(const LinePlace& place,
                                        const std::shared_ptr<const ConicForms>& forms,
                                        const RealAlgebraic& s);

/// The system's pieces with a t for which phi(t) = lambda at a solution (r,s); of two with the same t, the
/// first.
std::vector<std::size_t> pieces_at(const LineSystem& system, const TriangularPoint& at);

/// Refines boxes until they are pairwise disjoint; the points must be different.
void separate(std::vector<CertifiedPoint>& points);

}  // namespace exsect
