// Root isolation for a polynomial that is known up to an error and a positive factor.
#pragma once

#include <exsect/algebra/rational.h>

#include <optional>
#include <vector>

namespace exsect {

/// All polynomials a sum c_i t^i, a > 0, with |c_i - coefficients[i]| <= error.
struct EnclosedPolynomial {
  std::vector<Integer> coefficients;  // constant term first
  Integer error;
};

/// Pairwise disjoint open intervals in (0,1), ascending: each holds exactly one root of each of these
/// polynomials, a simple one, and no other point of [0,1] is a root. Empty if the enclosure does not decide
/// that.
std::optional<std::vector<RationalInterval>> isolate_enclosed_roots(const EnclosedPolynomial& f);

}  // namespace exsect
