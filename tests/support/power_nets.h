// Patches from the coefficients of their homogeneous coordinates in the power basis.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

#include "support/graph_patches.h"

namespace exsect::testing {

/// c[i][j] multiplies a^i b^j, of X in R^4.
using PowerNet = std::vector<std::vector<HomogeneousPoint>>;

/// Over [from,to]^2, which is mapped affinely to [0,1]^2.
RationalPatch power_patch(const PowerNet& c, const Rational& from, const Rational& to);

/// The polynomial patch with these coordinates over [0,1]^2, of bidegree (degree,degree), which they have at
/// most.
RationalPatch power_patch(const std::array<Terms, 3>& coordinates, int degree);

}  // namespace exsect::testing
