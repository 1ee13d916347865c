// Pictures of the three methods side by side.
#pragma once

#include <string>

#include "output/text/comparison.h"

namespace exsect::cli {

/// Parameter lines in (u,v), the resultant's curve in (u,r), the curves of the quartics in (u,v), of whole y
/// and of its pieces: the intersection in colours, phantoms in grey.
std::string comparison_svg(const Comparison& comparison, const std::string& title);

}  // namespace exsect::cli
