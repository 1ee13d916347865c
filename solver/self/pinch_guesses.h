// Where pinch points may be. Internal to solver/; docs/method-doubles.md, section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

namespace exsect {

/// Parameters (u,v) in the square at which x_u x x_v = 0 as far as doubles tell, some of them, each once:
/// guesses.
std::vector<std::array<double, 2>> pinch_guesses(const RationalPatch& patch);

}  // namespace exsect
