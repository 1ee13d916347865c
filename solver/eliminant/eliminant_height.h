// A proved bound of the size of the coefficients of the turning eliminant.
#pragma once

#include <exsect/geometry/integer_pair.h>

namespace exsect {

/// Bounds, in bits, of means over the circle |u| = 1.
struct HeightTerms {
  double jacobian;  // log2 |J| / (max(1,|r|) max(1,|s|))^5 at a point of the fibre, from above
  double r_s;       // log2 of the 2-norm of R in Z[u,s], from above
  double r_r;       // the same with r and s exchanged
  double g_r;       // log2 |g_r|, from below
  double g_s;       // log2 |g_s|, from below
};

/// Throws std::domain_error if n, g_r or g_s vanishes identically (then E is zero or not defined by (4.8)).
HeightTerms height_terms(const IntegerPair& pair);

/// A number b with |e_j| < 2^b for every coefficient of E(u) of the pair: docs/method.md, (4.16). Rigorous
/// for integers of any size; usually within 400 bits of the truth. Throws as height_terms.
std::size_t eliminant_height_bound(const IntegerPair& pair);

}  // namespace exsect
