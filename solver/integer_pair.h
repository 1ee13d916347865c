// A pair of patches with integer coefficients in the power basis.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>

namespace exsect {

/// x = sum x[i][j] u^i v^j and y = sum y[i][j] r^i s^j, each coefficient a vector of three integers.
/// Invariant: x[0][0] = 0, and for each coordinate the 18 coefficients have greatest common divisor 1 or are
/// all zero.
struct IntegerPair {
  using Net = std::array<std::array<std::array<Integer, 3>, 3>, 3>;
  Net x;
  Net y;
};

/// The image of the pair under the translation by -x(0,0) followed by the scaling of each coordinate with the
/// positive rational that establishes the invariant: the same solutions (u,v,r,s) of x = y.
IntegerPair integer_pair(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect
