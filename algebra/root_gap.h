// Intervals next to 0 that a polynomial has no root in, from the sizes of its coefficients. Internal to
// algebra/.
#pragma once

#include "flint_polynomial.h"

namespace exsect {

/// A number k >= depth so that f has no root in [2^-k, 2^-depth], where one of its terms is greater than all
/// others together; `depth` itself, which says nothing, where none is known to be, and kNoRoot if there is no
/// root in (0, 2^-depth]. Requires f != 0.
long root_free_depth(const fmpz_poly_t f, long depth);
constexpr long kNoRoot = 1L << 60;

}  // namespace exsect
