// A pair of patches and their parameter lines on integers: the fast way into the solver.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>

namespace exsect {

using IntegerVector = std::array<Integer, 3>;
/// c[i][j], the vector coefficient of the first parameter's power i times the second's power j.
using IntegerNet = std::array<std::array<IntegerVector, 3>, 3>;

/// x = sum x[i][j] u^i v^j and y = sum y[i][j] r^i s^j. Invariant: x[0][0] = 0, and for each coordinate the
/// 18 coefficients have greatest common divisor 1 or are all zero.
struct IntegerPair {
  using Net = IntegerNet;
  Net x;
  Net y;
};

/// The image of the pair under the translation by -x(0,0) followed by the scaling of each coordinate with the
/// positive rational that establishes the invariant: the same solutions (u,v,r,s) of x = y.
IntegerPair integer_pair(const BezierPatch& x, const BezierPatch& y);

/// The net with its two parameters exchanged.
IntegerNet exchanged(const IntegerNet& net);

/// p(t) = (a[0] + a[1] t + a[2] t^2) / weight, weight > 0: homogeneous coordinates over the integers.
struct IntegerLine {
  std::array<IntegerVector, 3> a;
  Integer weight;
};
/// The line where the net's first parameter is u0.
IntegerLine line_at_first(const IntegerNet& net, const Rational& u0);

/// True if a[1] x a[2] != 0: shape(line) is conic.
bool is_conic(const IntegerLine& line);

}  // namespace exsect
