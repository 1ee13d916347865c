// The result of `exsect line` as text for a reader.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/line_patch.h>

#include <string>

namespace exsect::cli {

/// Shape, pull-back, eliminant, feasible intervals, points and what is not known, ending with a line feed. x
/// is the patch of (u,v).
std::string line_summary(const LineIntersection& line, const BezierPatch& x);

}  // namespace exsect::cli
