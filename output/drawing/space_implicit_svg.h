// Pictures of pairs of surfaces through a curve of space.
#pragma once

#include "output/text/space_implicit_output.h"

namespace exsect::cli {

/// Both projections with the zero sets of f and g.
std::string space_implicit_svg(const SpaceImplicit& implicit, const BezierCurve& curve,
                               const std::string& title);

}  // namespace exsect::cli
