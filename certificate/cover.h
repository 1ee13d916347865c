// The cover of what is not on the curves. Internal to certificate/.
#pragma once

#include "certificate/search.h"

namespace exsect::cli {

/// The direction with integer components that the vector points to, none above `size`.
std::array<int, 3> rounded_direction(const std::array<double, 3>& d, double size = 100);

/// The subdivision of [0,1]^4, or of its part on the line, in preorder: "u", "t5", "3,-1,2".
std::vector<std::string> cover(const NearPair& pair, const Places& places,
                               const std::optional<LineQuery>& line = {});

}  // namespace exsect::cli
