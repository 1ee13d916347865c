// Root isolation for a polynomial that is given by balls around its Chebyshev coefficients.
#pragma once

#include <exsect/algebra/wide_ball.h>

#include <optional>
#include <vector>

namespace exsect {

/// Pairwise disjoint open intervals in (0,1), ascending: each holds exactly one root of each of the
/// polynomials sum c_j T_j(2u - 1), a simple one, and no other point of [0,1] is a root; at most 253
/// coefficients. Empty if the balls do not decide that.
std::optional<std::vector<RationalInterval>> isolate_chebyshev_roots(const std::vector<WideBall>& c);

}  // namespace exsect
