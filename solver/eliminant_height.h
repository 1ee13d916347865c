// A proved bound of the size of the coefficients of the turning eliminant.
#pragma once

#include <exsect/geometry/integer_pair.h>

namespace exsect {

/// A number b with |e_j| < 2^b for every coefficient of E(u) of the pair: docs/method.md, (4.13). Rigorous
/// for integers of any size; usually within 400 bits of the truth. Throws std::domain_error if n, g_r or g_s
/// vanishes identically (then E is zero or not defined by (4.8)).
std::size_t eliminant_height_bound(const IntegerPair& pair);

}  // namespace exsect
