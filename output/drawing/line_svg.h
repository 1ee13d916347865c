// A parameter line against a patch as a picture, like Fig. 9.4 (right) of the chapter.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/line_patch.h>

#include <string>

namespace exsect::cli {

/// The parameter square of the other patch with the eliminant's variable to the right: both branches of the
/// pulled-back plane P = 0, the restriction curves where the line's parameter is 0 and 1, the second surface
/// through the line, the feasible intervals as bars on the axis, the points. The curves are sampled in
/// doubles.
std::string line_svg(const LineIntersection& line, const RationalPatch& x, const std::string& title);

}  // namespace exsect::cli
