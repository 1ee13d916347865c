// The control net of a piece of a patch, exact.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

namespace exsect {

/// Of the patch with the vectors X_ij at i (n+1) + j, the vectors of the piece over [u0,u1] x [v0,v1],
/// u = {u0, u1}, v = {v0, v1}, reparametrised affinely to [0,1]^2, whatever these numbers are: the entry
/// (i,j) is the polar form of X with i arguments u1, m-i arguments u0, j arguments v1 and n-j arguments v0.
/// All of it in integers over one denominator for each coordinate, reduced to lowest terms once. Requires m,
/// n >= 1.
std::vector<HomogeneousPoint> net_of_piece(const std::vector<HomogeneousPoint>& net, int m, int n,
                                           const std::array<Rational, 2>& u,
                                           const std::array<Rational, 2>& v);

}  // namespace exsect
