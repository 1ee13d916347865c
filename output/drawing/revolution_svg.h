// Pictures of surfaces of revolution. Internal to output/.
#pragma once

#include "output/text/revolution_output.h"

namespace exsect::cli {

/// The rz half plane: the profile, the zero set, the mirrored branches that elimination and product add, and
/// the rings; beside it the curve in the parameter square of the patch.
std::string revolution_svg(const ShownRevolution& shown, const std::string& title);

}  // namespace exsect::cli
