// Everything about a parameter line where one of the patches has weights or degree 3. Internal to solver/.
#pragma once

#include <exsect/solver/line_intersection.h>

namespace exsect {

/// As intersect_line, with patches of every kind.
LineIntersection rational_line_intersection(const RationalPatch& x, const RationalPatch& y,
                                            const LineQuery& query);

}  // namespace exsect
