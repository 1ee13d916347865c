// A pair of patches with weights on integers, as the eliminant takes it. Internal to solver/.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>

namespace exsect {

/// X = sum x[i][j] u^i v^j and Y = sum y[i][j] r^i s^j in homogeneous coordinates (16.1). Invariant: all
/// coefficients of each patch have greatest common divisor 1; the first three coordinates of x[0][0] are
/// zero.
struct WeightedPair {
  using Vector = std::array<Integer, 4>;
  using Net = std::array<std::array<Vector, 3>, 3>;
  Net x;
  Net y;
};

/// The image of the pair under the translation by -x(0,0), a scaling of each coordinate and of each patch by
/// positive rationals: the same solutions. Requires x and y of bidegrees at most (2,2).
WeightedPair weighted_pair(const RationalPatch& x, const RationalPatch& y);

}  // namespace exsect
