// A proved bound of the size of the coefficients of the turning eliminant of patches with weights. Internal
// to solver/.
#pragma once

#include <cstddef>

#include "eliminant/weighted_pair.h"

namespace exsect {

/// A number b with |e_j| < 2^b for every coefficient of E(u): docs/method-equations.md, (16.12), (16.18).
/// Rigorous for integers of any size; usually within 700 bits of the truth. Throws std::domain_error if a
/// coordinate, x_v, the normal of y or R vanishes identically (then E is not defined).
std::size_t eliminant_height_bound(const WeightedPair& pair);

}  // namespace exsect
