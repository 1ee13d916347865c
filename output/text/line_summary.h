// The result of `exsect line` as text for a reader.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/line_patch.h>

#include <string>

namespace exsect::cli {

/// Shape, pull-back, eliminant, feasible intervals, points and what is not known, ending with a line feed.
/// Digits are proved, more of them where `verbose`. x is the patch of (u,v), y that of (r,s).
std::string line_summary(const LineIntersection& line, const RationalPatch& x, const RationalPatch& y,
                         bool verbose);

}  // namespace exsect::cli
