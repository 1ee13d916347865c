// A proof modulo a prime that a net is in its lowest form. Used by rational_patch.h alone.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <vector>

namespace exsect {

/// True only if the four components of X, whose vectors X_ij stand at i (n+1) + j, have no common factor, X
/// is of degree m in u and n in v, and all weights are 1 if they are equal: then (16.2) changes nothing.
/// False: not known. Requires m, n >= 1 and X_4 > 0 on the square.
///
/// Let p be a prime that divides no denominator, and v0 such that X_4(u,v0) and a combination of the others,
/// modulo p and as forms of degree m, have no common zero, by their resultant. Then X is of degree m in u.
/// Let g be a common factor, primitive over Z. By Gauss' lemma it divides the components modulo p as well;
/// the coefficient of its highest power of u does not vanish at v0 modulo p, for it divides that of u^m in
/// all of them, which do not all vanish. So deg_u g is that of g(u,v0) modulo p, which is 0. The same with u
/// and v exchanged.
bool is_surely_reduced(const std::vector<HomogeneousPoint>& net, int m, int n);

}  // namespace exsect
